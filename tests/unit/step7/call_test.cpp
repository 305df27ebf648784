// Which actual parameters CALL takes. The code it becomes: call_function_test, call_instance_test.
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
  EXPECT_NE(compiled.listing(BlockKind::OB, 1).find("T     LW 43"), std::string::npos)
      << compiled.listing(BlockKind::OB, 1);
}

}  // namespace
}  // namespace merker::step7
