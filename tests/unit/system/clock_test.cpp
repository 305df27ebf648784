#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kTimes =
    "DATA_BLOCK DB 1\nSTRUCT\n a : DATE_AND_TIME := DT#1998-12-31-23:59:59.000;\n b : "
    "DATE_AND_TIME;\n"
    " c : DATE_AND_TIME := DT#1998-04-14-17:53:17.333;\n d : "
    "DATE_AND_TIME;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

Plc plcWith(std::string_view body) {
  return Plc(std::string(kTimes) +
             "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
             std::string(body) + "\nEND_ORGANIZATION_BLOCK\n");
}

// S7-SFC-02
TEST(Clock, IsSetAndRead) {
  Plc plc = plcWith(
      "U M 0.0; SPB M001; SET; = M 0.0; CALL SFC 0 (PDT := DB1.a, RET_VAL := MW 10);"
      "M001: CALL SFC 1 (RET_VAL := MW 12, CDT := DB1.b);");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 10"), 0u);
  EXPECT_EQ(plc.read("DB1.DBD 8"), 0x98123123u);
  EXPECT_EQ(plc.read("DB1.DBW 12"), 0x5959u);
  plc.run(Duration::milliseconds(1010));
  EXPECT_EQ(plc.read("DB1.DBD 8"), 0x99010100u);
}

// S7-SFC-22
TEST(Clock, TimeTick) {
  Plc plc("CALL SFC 64 (RET_VAL := MD 0);");
  plc.start();
  plc.run(Duration::milliseconds(1'000));
  EXPECT_NEAR(plc.read("MD 0"), 1000, 1);
}

// S7-IEC-01, S7-IEC-02
TEST(DateAndTime, Calculations) {
  Plc plc = plcWith(
      "CALL FC 1 (T := DB1.a, D := T#2S, RET_VAL := DB1.b); U BIE; = M 40.0;"
      "CALL FC 35 (T := DB1.b, D := T#2S, RET_VAL := DB1.d);"
      "CALL FC 34 (DT1 := DB1.b, DT2 := DB1.a, RET_VAL := MD 0);"
      "CALL FC 6 (IN := DB1.c, RET_VAL := MW 4); CALL FC 7 (IN := DB1.c, RET_VAL := MW 6);"
      "CALL FC 8 (IN := DB1.c, RET_VAL := MD 8);"
      "CALL FC 14 (DT1 := DB1.a, DT2 := DB1.c, RET_VAL := M 20.0);"
      "CALL FC 9 (DT1 := DB1.a, DT2 := DB1.d, RET_VAL := M 20.1);"
      "CALL FC 23 (DT1 := DB1.a, DT2 := DB1.c, RET_VAL := M 20.2);");
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("DB1.DBD 8"), 0x99010100u);
  EXPECT_EQ(plc.read("DB1.DBW 12"), 0x0001u);
  EXPECT_EQ(plc.read("DB1.DBD 24"), 0x98123123u);
  EXPECT_EQ(plc.read("MD 0"), 2000u);
  EXPECT_EQ(plc.read("MW 4"), 3025u);
  EXPECT_EQ(plc.read("MW 6"), 3u);
  EXPECT_EQ(plc.read("MD 8"), 64397333u);
  EXPECT_EQ(plc.read("MB 20"), 0x03u);
  EXPECT_EQ(plc.read("M 40.0"), 1u);
}

// S7-IEC-02, S7-IEC-03
TEST(DateAndTime, Conversions) {
  Plc plc = plcWith(
      "CALL FC 3 (IN1 := D#1998-04-14, IN2 := TOD#17:53:17.333, RET_VAL := DB1.b);"
      "CALL FC 33 (IN := S5T#5S, RET_VAL := MD 0); CALL FC 40 (IN := T#5S, RET_VAL := MW 4);"
      "CALL FC 40 (IN := T#3H, RET_VAL := MW 6); UN BIE; = M 20.0;");
  plc.cycles(1);
  ASSERT_EQ(plc->mode(), Mode::Run) << plc->stopReason();
  EXPECT_EQ(plc.read("DB1.DBD 8"), 0x98041417u);
  EXPECT_EQ(plc.read("DB1.DBD 12"), 0x53173333u);
  EXPECT_EQ(plc.read("MD 0"), 5000u);
  EXPECT_EQ(plc.read("MW 4"), 0x0500u);
  EXPECT_EQ(plc.read("MW 6"), 0x3999u);
  EXPECT_EQ(plc.read("M 20.0"), 1u);
}

}  // namespace
}  // namespace merker::station::test
