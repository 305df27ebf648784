// What STEP 7 compiles although it is odd: a warning at most, and the code that was meant.
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

using List = std::vector<std::string>;

// S7-FB-05: the instance is empty and known, also where the FB is called before its declaration.
TEST(Tolerance, InstancesOfAnFbThatDeclaresNothing) {
  const Compiled compiled = compileText(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FB 11, DB 11\nEND_ORGANIZATION_BLOCK\n"
      "DATA_BLOCK DB 11\nFB 11\nBEGIN\nEND_DATA_BLOCK\n"
      "FUNCTION_BLOCK FB 11\nBEGIN\nSET\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 12\nVAR x : FB 11; END_VAR\nBEGIN\nCALL #x\nCALL x\nEND_FUNCTION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), List{});
  EXPECT_TRUE(compiled.block(BlockKind::DB, 11).actualData.empty());
  EXPECT_EQ(compiled.block(BlockKind::FB, 12).instanceBytes, 0u);
}

// S7-SYM-05: the same bytes as with quotation marks, and a warning.
TEST(Tolerance, SymbolsWithoutQuotationMarks) {
  source::SymbolTable symbols;
  for (const auto& [name, address] : {std::pair("Motor_1", "A 1.0"), std::pair("Drive", "FC 1"),
                                      std::pair("Axis", "FB 1"), std::pair("Data", "DB 1")}) {
    source::Symbol symbol;
    symbol.name = name;
    symbol.address = source::parseSymbolAddress(address, {}).value();
    EXPECT_TRUE(symbols.add(symbol));
  }
  const std::string rest =
      "FUNCTION FC 1 : VOID\nVAR_INPUT i : BOOL; END_VAR\nEND_FUNCTION\n"
      "FUNCTION_BLOCK FB 1\nVAR_INPUT i : BOOL; END_VAR\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const auto compiled = [&](std::string_view code) {
    return compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\n" + std::string(code) +
                           "\nEND_ORGANIZATION_BLOCK\n" + rest,
                       "314C-2 PtP", false, &symbols);
  };
  const Compiled quoted = compiled(
      "U \"Motor_1\"\nCALL \"Drive\" (i := \"Motor_1\")\nCALL \"Axis\", \"Data\" (i := "
      "\"Data\".i)\nAUF DI \"Data\"");
  EXPECT_EQ(quoted.problems(), List{});
  const Compiled bare = compiled(
      "U Motor_1\nCALL #Drive (i := #motor_1)\nCALL Axis, Data (i := Data.i)\nAUF DI \"Data\"");
  EXPECT_EQ(bare.problems(), (List{"3:3 P0354", "4:7 P0354", "4:20 P0354", "5:6 P0354",
                                   "5:12 P0354", "5:23 P0354"}));
  EXPECT_EQ(bare.listing(BlockKind::OB, 1), quoted.listing(BlockKind::OB, 1));
  EXPECT_EQ(compiled("U Motor_2\nU #Motor_2").problems(), (List{"3:3 P0317", "4:4 P0313"}));
}

// S7-SRC-04: the order of the interface is kept whatever the source has.
TEST(Tolerance, SectionsOutOfOrder) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK FB 1\nVAR\ns : INT;\nEND_VAR\nVAR_OUTPUT\no : INT;\nEND_VAR\n"
      "VAR_INPUT\ni : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), (List{"5:1 P0409", "8:1 P0409"}));
  std::string order;
  for (const block::Variable& variable : compiled.block(BlockKind::FB, 1).variables)
    order += fmt::format("{}{} ", variable.name, variable.address / 8);
  EXPECT_EQ(order, "i0 o2 s4 ");
}

TEST(Tolerance, ADataBlockThatIsNotThere) {
  EXPECT_EQ(compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\nL DB99.DBW 0\nU DB 98.DBX 0.0\nAUF DB 97\n"
                        "END_ORGANIZATION_BLOCK\n")
                .problems(),
            (List{"3:3 P0522", "4:3 P0522"}));
}

// The time for each parameter does not grow with their number.
TEST(Tolerance, ManyParameters) {
  constexpr int kCount = 1500;
  std::string names, list;
  for (int i = 0; i < kCount; ++i) {
    names += fmt::format("p{} : INT;\n", i);
    list += fmt::format("p{} := {},\n", kCount - 1 - i, i);
  }
  const Compiled compiled =
      compileText("FUNCTION_BLOCK FB 1\nVAR_INPUT\n" + names +
                  "END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\n"
                  "END_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FB 1, DB 1 (" +
                  list + ")\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), List{});
  const std::string code = compiled.listing(BlockKind::OB, 1);
  EXPECT_NE(code.find("L     1499\nT     DIW 0\nL     1498\nT     DIW 2\n"), std::string::npos);
}

}  // namespace
}  // namespace merker::step7
