// Operands by name, as the command line takes them.
#include "step5/variable.h"

#include <gtest/gtest.h>

namespace merker::step5 {
namespace {

using address::OperandKind;

TEST(Variable, OperandsWithAValue) {
  const auto data = parseVariable("DB10.DW5");
  ASSERT_TRUE(data.has_value());
  EXPECT_EQ(data->db, 10);
  EXPECT_EQ(data->operand, address::memory(Area::DataBlock, Width::Word, bitAddress(10)));
  const auto bit = parseVariable(" DB 255.D 5.15 ");
  ASSERT_TRUE(bit.has_value());
  EXPECT_EQ(bit->db, 255);
  EXPECT_EQ(bit->operand, address::memory(Area::DataBlock, Width::Bit, bitAddress(10, 7)));
  EXPECT_EQ(parseVariable("DB5.D 3.0")->operand.value, bitAddress(7, 0));
  EXPECT_EQ(parseVariable("DB5.DL 3")->operand.value, bitAddress(6));
  EXPECT_EQ(parseVariable("DB5.DR 3")->operand.value, bitAddress(7));
  const auto input = parseVariable("E 12.7");
  ASSERT_TRUE(input.has_value());
  EXPECT_EQ(input->operand.area, Area::Input);
  EXPECT_EQ(input->db, -1);
  EXPECT_EQ(parseVariable("MW 10")->operand.width, Width::Word);
  EXPECT_EQ(parseVariable("T 5")->operand.kind, OperandKind::Timer);
  EXPECT_EQ(parseVariable("z31")->operand.kind, OperandKind::Counter);
}

TEST(Variable, OthersAreRefused) {
  for (const char* text : {"", "DW 5", "DB 10", "DB10.MW 5", "DB256.DW 0", "KH 12", "PB", "MW 10 x",
                           "=EIN", "E 1", "OB 1"})
    EXPECT_FALSE(parseVariable(text).has_value()) << text;
}

TEST(Variable, HasTheRangesOfThePlc) {
  const auto problem = [](const char* text) {
    const auto found = checkRange(text, nullptr, {});
    return found ? found->message : "good";
  };
  EXPECT_EQ(problem("E 0.8"), "bit 8 is outside 0..7 of SINUMERIK 810/820");
  EXPECT_EQ(problem("DB10.D 0.16"), "bit 16 is outside 0..15 of SINUMERIK 810/820");
  EXPECT_EQ(problem("MB 256"), "number 256 is outside 0..255 of SINUMERIK 810/820");
  EXPECT_EQ(problem("EW 127"), "number 127 is outside 0..126 of SINUMERIK 810/820");
  EXPECT_EQ(problem("T 99"), "number 99 is outside 0..31 of SINUMERIK 810/820");
  for (const char* text : {"E 127.7", "MB 255", "T 31", "DB10.DW 2000", "KH 12", "XY"})
    EXPECT_EQ(problem(text), "good") << text;
}

}  // namespace
}  // namespace merker::step5
