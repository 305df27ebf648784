// FC 2 … 39 on strings (S7-IEC-05 … -07).
#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kStrings =
    "DATA_BLOCK DB 1\nSTRUCT\n a : STRING [10] := 'ABCDE';\n b : STRING [10] := 'xy';\n r : STRING "
    "[20];\n s : STRING [3];\n"
    " n : STRING [10] := '+123';\n x : STRING [20] := "
    "'-1.5000000E+02';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
constexpr std::uint32_t kResult = 24, kShort = 46;  // bytes of r and s

Plc plcWith(std::string_view body) {
  Plc plc(std::string(kStrings) +
          "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
          std::string(body) + " U BIE; = M 100.0;\nEND_ORGANIZATION_BLOCK\n");
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  return plc;
}

std::string text(Plc& plc, std::uint32_t byte = kResult) {
  std::string result;
  const std::uint32_t length = plc.read("DB1.DBB " + std::to_string(byte + 1));
  for (std::uint32_t i = 0; i < length; ++i)
    result += static_cast<char>(plc.read("DB1.DBB " + std::to_string(byte + 2 + i)));
  return result;
}

struct Row {
  std::string_view call, result;
  unsigned bie;
};

TEST(Strings, Functions) {
  const Row rows[] = {
      {"CALL FC 2 (IN1 := DB1.a, IN2 := DB1.b, RET_VAL := DB1.r);", "ABCDExy", 1},
      {"CALL FC 4 (IN := DB1.a, L := 2, P := 2, RET_VAL := DB1.r);", "ADE", 1},
      {"CALL FC 4 (IN := DB1.a, L := 2, P := 0, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 4 (IN := DB1.a, L := 0, P := 2, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 4 (IN := DB1.a, L := 1, P := 6, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 4 (IN := DB1.a, L := 9, P := 3, RET_VAL := DB1.r);", "AB", 1},
      {"CALL FC 4 (IN := DB1.a, L := -1, P := 1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 4 (IN := DB1.a, L := 1, P := -1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 17 (IN1 := DB1.a, IN2 := DB1.b, P := 2, RET_VAL := DB1.r);", "ABxyCDE", 1},
      {"CALL FC 17 (IN1 := DB1.a, IN2 := DB1.b, P := 0, RET_VAL := DB1.r);", "xyABCDE", 1},
      {"CALL FC 17 (IN1 := DB1.a, IN2 := DB1.b, P := 9, RET_VAL := DB1.r);", "ABCDExy", 1},
      {"CALL FC 17 (IN1 := DB1.a, IN2 := DB1.b, P := -1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 20 (IN := DB1.a, L := 0, RET_VAL := DB1.r);", "", 1},
      {"CALL FC 32 (IN := DB1.a, L := 9, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 32 (IN := DB1.a, L := -1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 20 (IN := DB1.a, L := 2, RET_VAL := DB1.r);", "AB", 1},
      {"CALL FC 20 (IN := DB1.a, L := 9, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 20 (IN := DB1.a, L := -1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 32 (IN := DB1.a, L := 2, RET_VAL := DB1.r);", "DE", 1},
      {"CALL FC 26 (IN := DB1.a, L := 3, P := 2, RET_VAL := DB1.r);", "BCD", 1},
      {"CALL FC 26 (IN := DB1.a, L := 3, P := 6, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 26 (IN := DB1.a, L := 9, P := 4, RET_VAL := DB1.r);", "DE", 1},
      {"CALL FC 26 (IN := DB1.a, L := 0, P := 2, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 26 (IN := DB1.a, L := 2, P := 0, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 26 (IN := DB1.a, L := -1, P := 2, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := 2, P := 3, RET_VAL := DB1.r);", "ABxyE", 1},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := 0, P := 3, RET_VAL := DB1.r);", "ABCDE", 1},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := 1, P := 0, RET_VAL := DB1.r);", "xyBCDE", 1},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := 1, P := 9, RET_VAL := DB1.r);", "ABCDExy", 1},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := 9, P := 4, RET_VAL := DB1.r);", "ABCxy", 1},
      {"CALL FC 31 (IN1 := DB1.a, IN2 := DB1.b, L := -1, P := 1, RET_VAL := DB1.r);", "", 0},
      {"CALL FC 16 (I := 123, RET_VAL := DB1.r);", "+123", 1},
      {"CALL FC 5 (I := L#-70000, RET_VAL := DB1.r);", "-70000", 1},
      {"CALL FC 30 (IN := 1.500000e+000, RET_VAL := DB1.r);", "+0.1500000E+01", 1}};
  for (const Row& row : rows) {
    Plc plc = plcWith(row.call);
    EXPECT_EQ(text(plc), row.result) << row.call;
    EXPECT_EQ(plc.read("M 100.0"), row.bie) << row.call;
  }
}

// S7-IEC-06: truncation, BIE 0.
TEST(Strings, AreCutOff) {
  Plc plc = plcWith("CALL FC 2 (IN1 := DB1.a, IN2 := DB1.b, RET_VAL := DB1.s);");
  EXPECT_EQ(text(plc, kShort), "ABC");
  EXPECT_EQ(plc.read("M 100.0"), 0u);
}

TEST(Strings, NumbersAndRelations) {
  Plc plc = plcWith(
      "CALL FC 21 (S := DB1.a, RET_VAL := MW 0); CALL FC 11 (IN1 := DB1.a, IN2 := DB1.b, RET_VAL "
      ":= MW 2);"
      "CALL FC 38 (S := DB1.n, RET_VAL := MW 4); CALL FC 39 (S := DB1.x, RET_VAL := MD 6);"
      "CALL FC 37 (S := DB1.n, RET_VAL := MD 12); CALL FC 24 (S1 := DB1.a, S2 := DB1.b, RET_VAL := "
      "M 20.0);"
      "CALL FC 10 (S1 := DB1.a, S2 := DB1.b, RET_VAL := M 20.1); CALL FC 29 (S1 := DB1.a, S2 := "
      "DB1.b, RET_VAL := M 20.2);"
      "CALL FC 13 (S1 := DB1.a, S2 := DB1.a, RET_VAL := M 20.3);");
  EXPECT_EQ(plc.read("MW 0"), 5u);
  EXPECT_EQ(plc.read("MW 2"), 0u);
  EXPECT_EQ(plc.read("MW 4"), 123u);
  EXPECT_EQ(plc.read("MD 6"), 0xC3160000u);
  EXPECT_EQ(plc.read("MD 12"), 123u);
  EXPECT_EQ(plc.read("MB 20"), 0x0Du);
  Plc bad = plcWith("CALL FC 38 (S := DB1.a, RET_VAL := MW 0);");
  EXPECT_EQ(bad.read("M 100.0"), 0u);
}

}  // namespace
}  // namespace merker::station::test
