// What STEP 7 compiles although it is odd: a warning at most, and the code that was meant.
#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace merker::step7 {
namespace {

using List = std::vector<std::string>;

source::SymbolTable table(const std::vector<std::pair<std::string, std::string>>& rows) {
  source::SymbolTable symbols;
  for (const auto& [name, address] : rows) {
    source::Symbol symbol;
    symbol.name = name;
    symbol.address = source::parseSymbolAddress(address, {}).value();
    EXPECT_TRUE(symbols.add(symbol));
  }
  return symbols;
}

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
  const source::SymbolTable symbols =
      table({{"Motor_1", "A 1.0"}, {"Drive", "FC 1"}, {"Axis", "FB 1"}, {"Data", "DB 1"}});
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
  EXPECT_EQ(bare.problems(),
            (List{"3:3 P0354", "4:7 P0354", "4:20 P0354", "5:6 P0354", "5:12 P0354"}));
  EXPECT_EQ(bare.listing(BlockKind::OB, 1), quoted.listing(BlockKind::OB, 1));
  EXPECT_EQ(compiled("U Motor_2\nU #Motor_2").problems(), (List{"3:3 P0317", "4:4 P0313"}));
}

// S7-SYM-05: names of blocks and types, too.
TEST(Tolerance, BlockNamesWithoutQuotationMarks) {
  const source::SymbolTable symbols = table({{"Drive", "FC 1"},
                                             {"Axis", "FB 1"},
                                             {"Axis_1", "DB 1"},
                                             {"DB2_data", "DB 7"},
                                             {"Set", "UDT 2"},
                                             {"Lamp", "A 1.0"}});
  const auto compiled = [&](std::string_view text) {
    return compileText(text, "314C-2 PtP", false, &symbols);
  };
  const Compiled bare = compiled(
      "FUNCTION Drive : VOID\nBEGIN\nEND_FUNCTION\n"
      "TYPE Set\nSTRUCT\nw : INT;\nEND_STRUCT\nEND_TYPE\n"
      "FUNCTION_BLOCK Axis\nVAR\ns : ARRAY[1..2] OF Set;\nEND_VAR\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK Axis_1\nAxis\nBEGIN\ns[2].w := 5;\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB2_data Set\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_EQ(bare.problems(), (List{"1:10 P0354", "4:6 P0354", "9:16 P0354", "11:20 P0354",
                                   "14:12 P0354", "15:1 P0354", "19:12 P0354", "19:21 P0354"}));
  EXPECT_EQ(bare.block(BlockKind::DB, 1).actualData, (std::vector<std::uint8_t>{0, 0, 0, 5}));
  EXPECT_EQ(bare.block(BlockKind::DB, 7).actualData.size(), 2u);
  EXPECT_EQ(compiled("DATA_BLOCK Lamp\nBEGIN\nEND_DATA_BLOCK\n").problems()[1], "1:12 P0304");
  EXPECT_EQ(compiled("FUNCTION Other : VOID\nBEGIN\nEND_FUNCTION\n").problems(),
            (List{"1:10 P0305"}));
}

// The manual of STEP 7 writes the attributes of a function before its type.
TEST(Tolerance, AttributesBehindTheNameOfABlock) {
  const Compiled compiled = compileText(
      "FUNCTION FC 3 { S7_pdiag := 'true' } : INT\nTITLE = t\nBEGIN\nEND_FUNCTION\n"
      "DATA_BLOCK DB 3 { S7_m_c := 'true' }\nSTRUCT\na : "
      "INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n");
  EXPECT_EQ(compiled.problems(), List{});
  const block::Block& function = compiled.block(BlockKind::FC, 3);
  EXPECT_EQ(function.attributes.title, "t");
  ASSERT_EQ(function.attributes.system.size(), 1u);
  EXPECT_EQ(function.attributes.system[0].first, "S7_pdiag");
  ASSERT_NE(function.returnType, nullptr);
  EXPECT_EQ(function.returnType->code, TypeCode::Int);
  EXPECT_EQ(compiled.block(BlockKind::DB, 3).attributes.system.size(), 1u);
}

// "> I" as the manual of STEP 7 writes it; "= I 0.0" is an assignment.
TEST(Tolerance, ABlankBeforeTheTypeOfAComparison) {
  const std::string apart =
      statements("L 1\nL 2\n> I; ==  D // x\n<> R\n+ I\n- D;* R\n/ I\n+ 5\n= I 0.0\n");
  EXPECT_EQ(apart, statements("L 1\nL 2\n>I\n==D\n<>R\n+I\n-D\n*R\n/I\n+ 5\n= E 0.0\n"));
  EXPECT_NE(apart.find(">I"), std::string::npos);
  EXPECT_EQ(compileText("FUNCTION FC 1 : VOID\nBEGIN\n> X\n> I 5\nEND_FUNCTION\n").problems(),
            (List{"3:1 P0334", "4:1 P0334"}));
}

// What is missing is one problem for a block, where it uses it first.
TEST(Tolerance, MissingBlocksAndNamesAreReportedOnce) {
  const std::string uses =
      "L DB5.a;\nL DB5.b;\nL #c;\nT #c;\nU \"d\";\nU \"d\";\nL DB6.DBW 0;\n"
      "L DB6.DBW 2;\nL DB7.a;\n";
  EXPECT_EQ(compileText("FUNCTION FC 1 : VOID\nBEGIN\n" + uses +
                        "END_FUNCTION\nFUNCTION FC 2 : VOID\nBEGIN\nL DB5.a\nEND_FUNCTION\n")
                .problems(),
            (List{"3:3 P0506", "5:4 P0313", "7:3 P0303", "9:3 P0522", "11:3 P0506", "15:3 P0506"}));
  EXPECT_EQ(
      compileText("FUNCTION_BLOCK FB 1\nVAR\na : UDT 5;\nb : ARRAY[1..2] OF UDT 5;\nc : FB 7;\n"
                  "d : \"e\";\nf : FB 7;\ng : \"e\";\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n"
                  "TYPE UDT 6\nSTRUCT\na : UDT 5;\nEND_STRUCT;\nEND_TYPE\n")
          .problems(),
      (List{"3:5 P0428", "5:5 P0428", "6:5 P0303", "14:5 P0428"}));
}

// The caller's own FC 99 is not in the program; the function of the library that has its number is
// not meant.
TEST(Tolerance, OwnFunctionWithTheNumberOfALibraryFunction) {
  const auto call = [](std::string_view parameters) {
    return compileText("FUNCTION FC 50 : VOID\nBEGIN\nCALL FC 99 (" + std::string(parameters) +
                       ");\nSET\nEND_FUNCTION\n")
        .problems();
  };
  EXPECT_EQ(call("Raw := 'a)',\nLimit := MW (2, Scaled := MW 0"), (List{"3:1 P0506"}));
  EXPECT_EQ(call("Raw := 1, IN := MD 4"), (List{"3:13 P0511"}));
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

// Sources of the TIA Portal: % before absolute operands, the return value by the function's name.
TEST(Tolerance, WordsOfTheTiaPortal) {
  const source::SymbolTable symbols = table({{"Scale", "FC 1"}});
  const auto compiled = [&](std::string_view code) {
    return compileText("FUNCTION \"Scale\" : INT\nBEGIN\n" + std::string(code) +
                           "\nEND_FUNCTION\nDATA_BLOCK DB 1\nSTRUCT\na : INT;\nEND_STRUCT\nBEGIN\n"
                           "END_DATA_BLOCK\n",
                       "314C-2 PtP", false, &symbols);
  };
  const Compiled marked = compiled("U %E0.0\nL %DB1.DBW0\nT #\"Scale\"");
  EXPECT_EQ(marked.problems(), List{});
  EXPECT_EQ(marked.listing(BlockKind::FC, 1),
            compiled("U E 0.0\nL DB1.DBW 0\nT #RET_VAL").listing(BlockKind::FC, 1));
  EXPECT_EQ(compiled("U %").problems(), (List{"3:3 P0316"}));
}

// One problem for the whole source, at the word that tells the language.
TEST(Tolerance, SourcesInOtherLanguages) {
  const Compiled scl = compileText(
      "FUNCTION_BLOCK FB 1\nVAR_TEMP\ni : INT;\nEND_VAR\nBEGIN\nIF i > 5 THEN\n  i := 0;\nEND_IF;\n"
      "END_FUNCTION_BLOCK\n");
  EXPECT_EQ(scl.problems(), (List{"8:1 P0334"}));
  const Compiled label = compileText(
      "FUNCTION FC 1 : VOID\nTITLE =END_IF\n// END_IF\nBEGIN\nL 'END_IF'; // "
      "END_IF\nEND_FUNCTION\n");
  EXPECT_EQ(label.problems(), (List{"5:3 P0204"}));
}

// Of one source: what is above is left out, and memory stays bounded.
TEST(Tolerance, VeryManyBlocks) {
  std::string text;
  for (int i = 0; i < 20'001; ++i) text += "FUNCTION FC 1 : VOID\nEND_FUNCTION\n";
  const Compiled compiled = compileText(text);
  const auto problems = compiled.problems();
  EXPECT_NE(std::find(problems.begin(), problems.end(), "40001:1 P0106"), problems.end());
}

// Functions of an S7-400 or of a CPU with a bus: a warning, and the code that was meant.
TEST(Tolerance, SystemFunctionsOfOtherCpus) {
  const std::string program =
      "FUNCTION FC 1 : VOID\nBEGIN\n"
      "CALL SFC 12 (REQ := TRUE, MODE := B#16#1, LADDR := W#16#10, RET_VAL := MW 0, BUSY := M "
      "2.0)\n"
      "CALL SFB 19, DB 8 (REQ := M 0.0, ID := W#16#1, ARG := P#M 20.0 BYTE 2)\nEND_FUNCTION\n"
      "DATA_BLOCK DB 8\nSFB 19\nBEGIN\nID := W#16#2;\nEND_DATA_BLOCK\n";
  const Compiled generic = compileText(program, "generic");
  EXPECT_EQ(generic.problems(), (List{"3:6 P0508", "4:6 P0508"}));
  EXPECT_EQ(generic.block(BlockKind::DB, 8).actualData.size(), 30u);
  EXPECT_NE(generic.listing(BlockKind::FC, 1).find("UC    SFC 12"), std::string::npos);
  const auto refused = compileText(program).problems();
  EXPECT_NE(std::find(refused.begin(), refused.end(), "3:6 P0506"), refused.end());
}

}  // namespace
}  // namespace merker::step7
