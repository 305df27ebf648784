// Bad input: each problem at its place, all in one pass, nothing worse.
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

using List = std::vector<std::string>;

List inOb(std::string_view code) {
  return compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\n" + std::string(code) +
                     "\nEND_ORGANIZATION_BLOCK\n")
      .problems();
}

TEST(Problem, EachStatementReportsItsOwn) {
  EXPECT_EQ(inOb("U E 0.8\nXYZ 5\nL MW 255\nT PEB 0\nL PAB 0\nLC MW 0\nU T 1.0\nSE T 256\nSPA "
                 "weg\nL \"no\"\nSET;"),
            (List{"3:3 P0213", "4:1 P0334", "5:3 P0214", "6:3 P0323", "7:3 P0324", "8:4 P0311",
                  "9:3 P0215", "10:4 P0214", "11:5 P0330", "12:3 P0303"}));
}

// S7-INSTR-12 to 17, S7-INSTR-71
TEST(Problem, ConstantsOfOperations) {
  EXPECT_EQ(inOb("+ 5.0\n+ T#1S\n+ W#16#5\n+ -5\n+ L#70000"),
            (List{"3:3 P0348", "4:3 P0348", "5:3 P0348"}));
  EXPECT_EQ(inOb("UD -1\nOD 1.0\nUD W#16#5\nUW DW#16#5\nUW S5T#1S\nUW 2#1\nXOD B#(1,2,3,4)"),
            (List{"3:4 P0343", "4:4 P0343", "5:4 P0343", "6:4 P0343", "7:4 P0343"}));
}

// The label belongs to the bracket it is jumped to from: the EN of a KOP box.
TEST(Problem, JumpInsideABracketIsNone) {
  EXPECT_EQ(inOb("U(; U M 0.0; SPBNB _001; L 5; T MW 0; _001: U BIE; ); = M 2.0"), List{});
}

TEST(Problem, StringsWithQuotationMarks) {
  const Compiled compiled = compileText(
      "DATA_BLOCK DB 1\nSTRUCT\n s : STRING [6] := 'it$'s'; t : STRING [4];\nEND_STRUCT\nBEGIN\n t "
      ":= 'a$'b';\nEND_DATA_BLOCK\n");
  EXPECT_EQ(compiled.problems(), List{});
  const std::vector<std::uint8_t> expected{6, 4, 'i', 't', '\'', 's', 0,
                                           0, 4, 3,   'a', '\'', 'b', 0};
  EXPECT_EQ(compiled.block(BlockKind::DB, 1).actualData, expected);
}

// POS-OVW-01: the name of the CPU as it is called, once
TEST(Problem, CpuWithoutTheFunctionBlock) {
  const Compiled compiled =
      compileText("DATA_BLOCK DB 22\nSFB 46\nBEGIN\nEND_DATA_BLOCK\n", "313C");
  ASSERT_EQ(compiled.problems(), List{"2:1 P0433"});
  EXPECT_EQ(compiled.result.problems.list().front().message, "CPU 313C has no SFB 46");
}

TEST(Problem, DeepNestingIsRefused) {
  std::string nested = "DATA_BLOCK DB 1\n", udts;
  for (int i = 0; i < 20'000; ++i) nested += "STRUCT a : ";
  EXPECT_FALSE(compileText(nested).result.ok());
  for (int i = 1; i < 5000; ++i)
    udts += fmt::format("TYPE UDT {}\nSTRUCT\n a : UDT {};\nEND_STRUCT\nEND_TYPE\n", i, i + 1);
  EXPECT_FALSE(compileText(udts).result.ok());
}

TEST(Problem, MissingStartValue) {
  EXPECT_EQ(compileText("DATA_BLOCK DB 1\nSTRUCT\n a : INT := ;\nEND_STRUCT\nEND_DATA_BLOCK\n")
                .problems(),
            (List{"3:13 P0412"}));
}

TEST(Problem, TheContractsExample) {
  const Compiled compiled =
      compileText("ORGANIZATION_BLOCK OB 1\nBEGIN\n  L     MB 300;\nEND_ORGANIZATION_BLOCK\n");
  ASSERT_EQ(compiled.result.problems.size(), 1u);
  EXPECT_EQ(compiled.result.problems.list()[0].message,
            "flag byte 300 is outside 0..255 of CPU 314C-2 PtP");
}

TEST(Problem, Brackets) {
  EXPECT_EQ(inOb("U(\nO M 0.0\nNETWORK\n)"), (List{"3:1 P0344", "6:1 P0337"}));
  EXPECT_EQ(inOb("U(;U(;U(;U(;U(;U(;U(;U(;U M 0.0;);););););););)"), (List{"3:22 P0336"}));
  EXPECT_EQ(inOb("SPA a; U(; a: U M 0.0; )"), (List{"3:12 P0333"}));
}

TEST(Problem, BlocksAndCalls) {
  EXPECT_EQ(
      compileText(
          "FUNCTION FC 1 : VOID\nBEGIN\nCALL FC 9\nUC FC 8\nCALL OB 1\nCALL FB 2\nEND_FUNCTION\n")
          .problems(),
      (List{"3:6 P0506", "4:4 P0508", "5:6 P0510", "6:6 P0506"}));
  EXPECT_EQ(compileText("FUNCTION FC 200 : VOID\nBEGIN\nEND_FUNCTION\nDATA_BLOCK DB "
                        "0\nSTRUCT\na:INT;\nEND_STRUCT\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB "
                        "101\nEND_ORGANIZATION_BLOCK\n")
                .problems(),
            (List{"1:10 P0502", "4:12 P0502", "9:20 P0502"}));
  EXPECT_EQ(compileText("FUNCTION FC 1 : VOID\nEND_FUNCTION\nFUNCTION FC 1 : VOID\nEND_FUNCTION\n")
                .problems(),
            (List{"3:10 P0501"}));
  EXPECT_EQ(compileText("FUNCTION FC 1 : VOID\nBEGIN\nSET\n").problems(), (List{"1:10 P0310"}));
  EXPECT_EQ(compileText("FUNCTION FC 1 : VOID\nBEGIN\nSET\nFUNCTION FC 2 : VOID\nEND_FUNCTION\n")
                .problems(),
            (List{"4:1 P0310"}));
}

TEST(Problem, Parameters) {
  const std::string fc =
      "FUNCTION FC 1 : VOID\nVAR_INPUT a : INT; END_VAR\nVAR_OUTPUT q : INT; END_VAR\nBEGIN\nT "
      "#a\nEND_FUNCTION\n";
  EXPECT_EQ(compileText(fc).problems(), (List{"5:3 P0325"}));  // S7-FC-06
  const std::string good =
      "FUNCTION FC 1 : VOID\nVAR_INPUT a : INT; END_VAR\nVAR_OUTPUT q : INT; "
      "END_VAR\nEND_FUNCTION\nFUNCTION FC 2 : VOID\nBEGIN\n";
  const auto call = [&](std::string_view text) {
    return compileText(good + std::string(text) + "\nEND_FUNCTION\n").problems();
  };
  EXPECT_EQ(call("CALL FC 1 (a := 1, q := MW 0)"), List{});
  EXPECT_EQ(call("CALL FC 1 (a := 70000, q := MW 0)"), (List{"7:17 P0202"}));
  EXPECT_EQ(call("CALL FC 1 (a := 1.5, q := MW 0)"), (List{"7:17 P0514"}));
  EXPECT_EQ(call("CALL FC 1 (a := MB 1, q := MW 0)"), (List{"7:17 P0514"}));
  EXPECT_EQ(call("CALL FC 1 (a := 1, q := 5)"), (List{"7:25 P0512"}));
  EXPECT_EQ(call("CALL FC 1 (a := 1)"), (List{"7:10 P0517"}));
  EXPECT_EQ(call("CALL FC 1 (a := 1, b := 2, q := MW 0)"), (List{"7:20 P0511"}));
  EXPECT_EQ(call("CALL FC 1 (a := MW [MD 2], q := MW 0)"), (List{"7:17 P0515"}));
  EXPECT_EQ(call("CALL FC 1 (a := 1\n, q := MW 0 )"), List{});
  EXPECT_EQ(call("UC FC 1"), (List{"7:4 P0509"}));  // S7-FC-02
}

TEST(Problem, Declarations) {
  EXPECT_EQ(
      compileText("FUNCTION FC 1 : VOID\nVAR\n a : INT;\nEND_VAR\nVAR_TEMP\n t : TIMER;\n x : INT "
                  ":= 5;\n x : INT;\n y : NIX;\n z : ARRAY [1..2] OF;\nEND_VAR\nEND_FUNCTION\n")
          .problems(),
      (List{"2:1 P0408", "6:6 P0426", "7:13 P0424", "8:2 P0422", "9:6 P0403", "10:21 P0403"}));
  EXPECT_EQ(compileText("TYPE UDT 1\nSTRUCT\n a : UDT 2;\nEND_STRUCT\nEND_TYPE\nTYPE UDT "
                        "2\nSTRUCT\n a : UDT 1;\nEND_STRUCT\nEND_TYPE\n")
                .problems(),
            (List{"8:6 P0421"}));
  EXPECT_EQ(
      compileText("FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : INT;\nBEGIN\nSET\nEND_FUNCTION_BLOCK\n")
          .problems(),
      (List{"2:1 P0410"}));
}

// An unknown type is one problem, and the code is checked all the same (S7-SRC-11).
TEST(Problem, UnknownTypesHaveNoConsequences) {
  EXPECT_EQ(
      compileText(
          "FUNCTION_BLOCK FB 1\nVAR_INPUT\na : NIX;\nb : UDT 9;\nc INT;\nEND_VAR\nVAR_TEMP\n"
          "f : ARRAY [1..2] OF NIX;\nEND_VAR\nBEGIN\nL #a;\nL #b.x[3];\nT #c;\nL #f[1];\n"
          "XYZ;\nEND_FUNCTION_BLOCK\n"
          "DATA_BLOCK DB 1\nFB 1\nBEGIN\na := 5;\nEND_DATA_BLOCK\n"
          "DATA_BLOCK DB 2\nUDT 9\nBEGIN\nx := 5;\nEND_DATA_BLOCK\n"
          "ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL FB 1, DB 1 (a := 5, b := MW 2);\nL DB1.a;\n"
          "L DB2.x;\nEND_ORGANIZATION_BLOCK\n")
          .problems(),
      (List{"3:5 P0403", "4:5 P0428", "5:3 P0402", "8:21 P0403", "15:1 P0334", "23:1 P0428"}));
}

TEST(Problem, UnclosedDeclarationsHaveNoConsequences) {
  EXPECT_EQ(
      compileText("FUNCTION_BLOCK FB 1\nVAR\ns : STRUCT\na : INT;\nEND_VAR\nBEGIN\nL #s.a;\nXYZ;\n"
                  "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nSTRUCT\nx : INT;\nBEGIN\nx := 5;\n"
                  "END_DATA_BLOCK\nTYPE UDT 1\nSTRUCT\nx : INT;\nEND_TYPE\n")
          .problems(),
      (List{"3:5 P0406", "8:1 P0334", "11:1 P0406", "17:1 P0406"}));
  EXPECT_EQ(
      compileText(
          "FUNCTION FC 1 : VOID\nVAR_INPUT\na : INT;\nVAR_TEMP\nb : INT;\nNETWORK\nL #a;\nT #b;\n"
          "XYZ;\nEND_FUNCTION\n")
          .problems(),
      (List{"2:1 P0410", "4:1 P0410", "9:1 P0334"}));
}

TEST(Problem, BlocksThatContainThemselves) {
  EXPECT_EQ(compileText("FUNCTION_BLOCK FB 1\nVAR\ns : FB 1;\nEND_VAR\nBEGIN\nCALL #s;\n"
                        "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n")
                .problems(),
            (List{"3:5 P0421"}));
}

TEST(Problem, AnUnclosedCommentIsTheOnlyProblem) {
  EXPECT_EQ(inOb("L 1;\n (* from here\nL 2;\nXYZ;"), (List{"4:2 P0350"}));
  EXPECT_EQ(
      compileText("(* all of it\nORGANIZATION_BLOCK OB 1\nEND_ORGANIZATION_BLOCK\n").problems(),
      (List{"1:1 P0350"}));
  EXPECT_EQ(
      compileText(
          "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\ns : STRUCT\na : INT; (* x\nEND_STRUCT;\nEND_VAR\n"
          "BEGIN\nEND_ORGANIZATION_BLOCK\n")
          .problems(),
      (List{"4:10 P0350"}));
}

TEST(Problem, TextsThatAreNoProgram) {
  EXPECT_EQ(compileText("").problems(), (List{"0:0 P0104"}));
  EXPECT_EQ(compileText("hello world\nthis is no AWL\n").problems(), (List{"1:1 P0306"}));
  EXPECT_EQ(compileText("U E 0.0").problems(), (List{"1:1 P0306"}));
}

// S7-INSTR-108, S7-INSTR-111
TEST(Problem, LabelsAndEnds) {
  EXPECT_EQ(inOb("SPA ab\nab: SET\nab: SET\nabcde: SET\nBE\nSET"),
            (List{"5:1 P0327", "6:1 P0332", "8:1 P0331"}));
}

}  // namespace
}  // namespace merker::step7
