// Operands as monitor, scenarios and --print name them.
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

class Resolve : public testing::Test {
 protected:
  Resolve()
      : compiled_(compileText("DATA_BLOCK DB 1\nSTRUCT\n w : WORD; a : ARRAY [1..3] OF STRUCT r : "
                              "REAL; END_STRUCT; END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n")) {
    source::Symbol motor;
    motor.name = "Motor";
    motor.address.area = Area::Output;
    motor.address.address = bitAddress(1, 0);
    symbols_.add(motor);
    options_.symbols = &symbols_;
  }
  Result<address::Reference> operator()(std::string_view text) {
    return resolve(text, compiled_.result.program, options_, {"-", 1, 1, 1});
  }

  Compiled compiled_;
  source::SymbolTable symbols_;
  CompileOptions options_;
};

TEST_F(Resolve, BothMnemonics) {
  for (const char* text : {"E 1.5", "I1.5", " i 1.5 "}) {
    const auto reference = (*this)(text);
    ASSERT_TRUE(reference) << text;
    EXPECT_EQ(reference->operand, address::memory(Area::Input, Width::Bit, bitAddress(1, 5)));
  }
  EXPECT_EQ((*this)("Z 7")->operand.kind, address::OperandKind::Counter);
  EXPECT_EQ((*this)("C 7")->operand.value, 7u);
}

TEST_F(Resolve, DataBlocksAndSymbols) {
  const auto element = (*this)("DB1.a[2].r");
  ASSERT_TRUE(element);
  EXPECT_EQ(element->db, 1);
  EXPECT_EQ(element->operand, address::memory(Area::DataBlock, Width::DWord, bitAddress(6)));
  EXPECT_EQ(element->type, TypeCode::Real);
  const auto motor = (*this)("\"Motor\"");
  ASSERT_TRUE(motor);
  EXPECT_EQ(motor->type, TypeCode::Bool);
  EXPECT_EQ(motor->operand, address::memory(Area::Output, Width::Bit, bitAddress(1, 0)));
}

TEST_F(Resolve, RefusesWhatIsNotVisibleFromOutside) {
  for (const char* text : {"", "L 1.0", "DBW 4", "DIW 2", "5", "MW [MD 2]", "DB1.a", "DB7.x",
                           "\"unknown\"", "MW 10 x", "FC 1"})
    EXPECT_FALSE((*this)(text)) << text;
}

}  // namespace
}  // namespace merker::step7
