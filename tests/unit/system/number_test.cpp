// FC 22, 25, 27, 36 and FC 105, 106 (S7-IEC-08, S7-IEC-09).
#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kNumbers =
    "DATA_BLOCK DB 1\nSTRUCT\n i0 : INT := 0;\n i5 : INT := 5;\n i7 : INT := 7;\n r : INT;\n x : "
    "REAL := 1.5;\n y : REAL := -2.5;\n"
    " z : REAL;\n w : INT := 13824;\n q : WORD;\n END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

Plc plcWith(std::string_view body) {
  Plc plc(std::string(kNumbers) +
          "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
          std::string(body) + " U BIE; = M 100.0;\nEND_ORGANIZATION_BLOCK\n");
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  return plc;
}

TEST(Select, LimitMaxMinSel) {
  const struct {
    std::string_view call;
    std::uint32_t result;
  } rows[] = {{"CALL FC 22 (MN := DB1.i0, IN := DB1.i7, MX := DB1.i5, RET_VAL := DB1.r);", 5},
              {"CALL FC 22 (MN := DB1.i5, IN := DB1.i0, MX := DB1.i7, RET_VAL := DB1.r);", 5},
              {"CALL FC 25 (IN1 := DB1.i0, IN2 := DB1.i7, IN3 := DB1.i5, RET_VAL := DB1.r);", 7},
              {"CALL FC 27 (IN1 := DB1.i5, IN2 := DB1.i7, IN3 := DB1.i0, RET_VAL := DB1.r);", 0},
              {"CALL FC 36 (G := TRUE, IN0 := DB1.i5, IN1 := DB1.i7, RET_VAL := DB1.r);", 7},
              {"CALL FC 36 (G := FALSE, IN0 := DB1.i5, IN1 := DB1.i7, RET_VAL := DB1.r);", 5}};
  for (const auto& row : rows) {
    Plc plc = plcWith(row.call);
    EXPECT_EQ(plc.read("DB1.r"), row.result) << row.call;
    EXPECT_EQ(plc.read("M 100.0"), 1u) << row.call;
  }
  Plc mixed = plcWith("CALL FC 25 (IN1 := DB1.i0, IN2 := DB1.x, IN3 := DB1.i5, RET_VAL := DB1.r);");
  EXPECT_EQ(mixed.read("M 100.0"), 0u);
  Plc reals = plcWith("CALL FC 27 (IN1 := DB1.x, IN2 := DB1.y, IN3 := DB1.x, RET_VAL := DB1.z);");
  EXPECT_EQ(reals.read("DB1.z"), 0xC0200000u);
}

TEST(Scale, ThereAndBack) {
  Plc plc = plcWith(
      "CALL FC 105 (IN := DB1.w, HI_LIM := 1.000000e+002, LO_LIM := 0.000000e+000, BIPOLAR := "
      "FALSE,"
      "RET_VAL := MW 0, OUT := MD 4);"
      "CALL FC 106 (IN := MD 4, HI_LIM := 1.000000e+002, LO_LIM := 0.000000e+000, BIPOLAR := FALSE,"
      "RET_VAL := MW 2, OUT := MW 8);");
  EXPECT_EQ(plc.read("MD 4"), 0x42480000u);  // 50.0
  EXPECT_EQ(plc.read("MW 8"), 13824u);
  EXPECT_EQ(plc.read("MW 0"), 0u);
  EXPECT_EQ(plc.read("M 100.0"), 1u);
  Plc outside = plcWith(
      "CALL FC 105 (IN := -5, HI_LIM := 1.000000e+002, LO_LIM := 0.000000e+000, BIPOLAR := FALSE,"
      "RET_VAL := MW 0, OUT := MD 4);");
  EXPECT_EQ(outside.read("MW 0"), 8u);
  EXPECT_EQ(outside.read("MD 4"), 0u);
  EXPECT_EQ(outside.read("M 100.0"), 0u);
}

}  // namespace
}  // namespace merker::station::test
