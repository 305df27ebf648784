// What CALL becomes (MC7 section 7): literal listings, so that a change of the macro is seen.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

constexpr const char* kFunction =
    "FUNCTION FC 1 : VOID\nVAR_INPUT\n a : INT; b : BOOL;\nEND_VAR\nVAR_OUTPUT\n q : "
    "BYTE;\nEND_VAR\n"
    "VAR_IN_OUT\n x : WORD;\nEND_VAR\nBEGIN\nL #a; U #b; T #q; T #x\nEND_FUNCTION\n";

std::string caller(std::string_view code, std::string_view temps = "t : WORD;") {
  return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n" + std::string(temps) + "\nEND_VAR\nBEGIN\n" +
         std::string(code) + "\nEND_ORGANIZATION_BLOCK\n";
}

// S7-PAR-01: direct operands by reference, constants in local data, temporary data as V.
TEST(Call, FunctionWithDirectOperands) {
  const Compiled compiled = compileText(
      std::string(kFunction) + caller("CALL FC 1 (a := 500, b := E 0.1, q := MB 0, x := #t);"));
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(compiled.listing(BlockKind::OB, 1),
            "BLD   1\nL     500\nT     LW 22\nUC    FC 1\nSPA   10\n      P#V 22.0\n      P#E "
            "0.1\n      P#M 0.0\n      P#V 20.0\nBLD   2\nBE\n");
  EXPECT_EQ(compiled.block(BlockKind::OB, 1).localBytes, 24u);
  EXPECT_EQ(compiled.listing(BlockKind::FC, 1),
            "L     W #P0\nU     #P1\nT     B #P2\nT     W #P3\nBE\n");
}

// S7-PAR-02: data block operands are copied before and after; the VKE survives the copies of BOOL
// values.
TEST(Call, FunctionWithDataBlockOperands) {
  const Compiled compiled = compileText(
      std::string(kFunction) +
      "DATA_BLOCK DB 5\nSTRUCT\n w : WORD; f : BOOL;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n" +
      caller("CALL FC 1 (a := MW 2, b := DB5.f, q := MB 0, x := DB5.w);"));
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(
      compiled.listing(BlockKind::OB, 1),
      "BLD   1\n=     L 22.0\nAUF   DB 5\nU     DBX 2.0\n=     L 23.0\nAUF   DB 5\nL     DBW 0\nT  "
      "   LW 24\n"
      "U     L 22.0\nUC    FC 1\nSPA   10\n      P#M 2.0\n      P#V 23.0\n      P#M 0.0\n      P#V "
      "24.0\n"
      "=     L 22.0\nL     LW 24\nAUF   DB 5\nT     DBW 0\nU     L 22.0\nSPBI  2\nBLD   2\nBE\n");
}

// S7-FB-13: values into the instance, call, values back; DI and AR2 restored.
TEST(Call, FunctionBlockWithInstance) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : INT;\nEND_VAR\nVAR_OUTPUT\n q : "
      "WORD;\nEND_VAR\nBEGIN\nL #a; T #q\nEND_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
      caller("CALL FB 1, DB 1 (a := EW 0, q := MW 0);"));
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(compiled.listing(BlockKind::OB, 1),
            "BLD   3\nTDB\nAUF   DI 1\nL     EW 0\nT     DIW 0\nTAR2  LD 22\nLAR2  P#DBX0.0\nUC    "
            "FB 1\nLAR2  LD 22\n"
            "L     DIW 2\nT     MW 0\nTDB\nBLD   4\nBE\n");
  EXPECT_EQ(compiled.listing(BlockKind::FB, 1),
            "L     DIW [AR2,P#0.0]\nT     DIW [AR2,P#2.0]\nBE\n");
}

// S7-PAR-10: an instance inside an instance is reached through AR2.
TEST(Call, MultipleInstance) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : INT;\nEND_VAR\nVAR\n s : "
      "INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 2\nVAR\n first : FB 1; second : FB 1;\nEND_VAR\nBEGIN\nCALL #second (a := "
      "7);\nL #second.s\nEND_FUNCTION_BLOCK\n");
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(compiled.listing(BlockKind::FB, 2),
            "BLD   3\nL     7\nT     DIW [AR2,P#4.0]\nTAR2  LD 0\n+AR2  P#4.0\nUC    FB 1\nLAR2  "
            "LD 0\nBLD   4\n"
            "L     DIW [AR2,P#6.0]\nBE\n");
}

// S7-IND-11, S7-IND-12: POINTER and ANY are built in local data.
TEST(Call, AnyAndPointer) {
  const Compiled compiled = compileText(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n p : POINTER; a : ANY; t : TIMER;\nEND_VAR\nBEGIN\nL P##a; "
      "SE #t\nEND_FUNCTION\n" +
      caller("CALL FC 1 (p := P#M10.0, a := P#DB10.DBX4.0 WORD 5, t := T 9);", ""));
  ASSERT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_EQ(compiled.listing(BlockKind::OB, 1),
            "BLD   1\nL     W#16#0000\nT     LW 20\nL     DW#16#83000050\nT     LD 22\n"
            "L     W#16#1004\nT     LW 26\nL     W#16#0005\nT     LW 28\nL     W#16#000A\nT     LW "
            "30\nL     DW#16#84000020\nT     LD 32\n"
            "UC    FC 1\nSPA   8\n      P#V 20.0\n      P#V 26.0\n      9\nBLD   2\nBE\n")
      << "a timer is handed over as its number";
}

// How a parameter and its actual operand are declared, and whether they fit (S7-PAR-04). Each is
// called several times, as the result is remembered.
struct Pair {
  const char* formal;
  const char* actual;
  bool fits;
};

constexpr const char* kTypes[] = {"",
                                  "a : INT; b : BOOL;",
                                  "x : INT; y : BOOL;",
                                  "a : INT; b : BYTE;",
                                  "s : STRING [20];",
                                  "s : STRING [22];",
                                  "u : UDT 1; w : UDT 1;",
                                  "u : UDT 2; w : UDT 1;",
                                  "u : UDT 1; w : UDT 3;"};

constexpr Pair kPairs[] = {
    {"UDT 1", "UDT 1", true},
    {"UDT 1", "UDT 2", true},
    {"UDT 1", "UDT 3", false},
    {"UDT 1", "STRUCT m : INT; n : BOOL; END_STRUCT", true},
    {"UDT 1", "STRUCT m : INT; END_STRUCT", false},
    {"UDT 1", "STRUCT m : INT; n, o : BOOL; END_STRUCT", false},
    {"UDT 1", "STRUCT m : BOOL; n : INT; END_STRUCT", false},
    {"UDT 4", "UDT 5", false},
    {"UDT 6", "UDT 7", true},
    {"UDT 6", "UDT 8", false},
    {"UDT 6", "STRUCT a : INT; b : BOOL; c : INT; d : BOOL; END_STRUCT", false},
    {"UDT 6", "ARRAY [1..2] OF UDT 1", false},
    {"ARRAY [1..2] OF UDT 6", "ARRAY [1..2] OF UDT 7", true},
    {"ARRAY [1..2] OF UDT 6", "ARRAY [1..2] OF UDT 8", false},
    {"ARRAY [1..2] OF UDT 6", "ARRAY [0..1] OF UDT 6", false},
    {"ARRAY [1..2] OF INT", "ARRAY [1..2,1..1] OF INT", false},
    {"ARRAY [1..2] OF INT", "ARRAY [1..2] OF WORD", false},
    {"DATE_AND_TIME", "DATE_AND_TIME", true},
    {"DATE_AND_TIME", "STRUCT a, b : DWORD; END_STRUCT", false},
    {"STRUCT a, b : DWORD; END_STRUCT", "DATE_AND_TIME", false},
};

std::vector<std::string> callsWith(const char* formal, const char* actual) {
  std::string source;
  for (std::size_t i = 1; i < std::size(kTypes); ++i)
    source += fmt::format("TYPE UDT {}\nSTRUCT\n{}\nEND_STRUCT;\nEND_TYPE\n", i, kTypes[i]);
  source += fmt::format(
      "FUNCTION FC 1 : VOID\nVAR_IN_OUT\n p : {};\nEND_VAR\nBEGIN\nEND_FUNCTION\n"
      "DATA_BLOCK DB 1\nSTRUCT\n v, w : {};\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n",
      formal, actual);
  return compileText(source + caller("CALL FC 1 (p := DB1.v);\nCALL FC 1 (p := DB1.w);\n"
                                     "CALL FC 1 (p := DB1.v);"))
      .problems();
}

TEST(Call, TypesOfParametersAreTheSameThroughout) {
  for (const Pair& pair : kPairs)
    for (const bool swapped : {false, true}) {
      const char* formal = swapped ? pair.actual : pair.formal;
      const char* actual = swapped ? pair.formal : pair.actual;
      const auto problems = callsWith(formal, actual);
      EXPECT_EQ(problems.size(), pair.fits ? 0u : 3u) << formal << " := " << actual;
      for (const std::string& problem : problems)
        EXPECT_TRUE(problem.ends_with("P0514")) << problem;
    }
}

// Local data that the program addresses absolutely are not used for parameters.
TEST(Call, ParametersKeepOutOfAbsoluteLocalData) {
  const Compiled compiled = compileText(
      std::string(kFunction) + caller("CALL FC 1 (a := 1, b := TRUE, q := LB 30, x := LW 40);"));
  EXPECT_EQ(compiled.problems(), std::vector<std::string>{});
  EXPECT_NE(compiled.listing(BlockKind::OB, 1).find("T     LW 44"), std::string::npos)
      << compiled.listing(BlockKind::OB, 1);
}

}  // namespace
}  // namespace merker::step7
