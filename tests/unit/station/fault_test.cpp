#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

// S7-DIAG-01, S7-TMR-04: the reason names block and line.
TEST(Faults, NameTheirPlace) {
  Plc plc("NOP 0;\nSET;\nL W#16#0ABC;\nSE T 1;\n");
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc->stoppedByFault());
  const std::string reason = plc->stopReason();
  EXPECT_NE(reason.find("16#4562"), std::string::npos) << reason;
  EXPECT_NE(reason.find("BCD"), std::string::npos) << reason;
  EXPECT_NE(reason.find("OB 1"), std::string::npos) << reason;
  EXPECT_NE(reason.find("test.awl:9"), std::string::npos) << reason;
}

// S7-SFC-17: the value that the faulty load is to give.
TEST(Faults, ReplacementValue) {
  Plc plc(ob(122, "CALL SFC 44 (VAL := DW#16#12345678, RET_VAL := MW 30);") +
          ob(1, "L PEW 400; T MD 0;"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 0"), 0x12345678u);
  EXPECT_EQ(plc.read("MW 30"), 0u);
}

// S7-SFC-14: masked, nothing is called; READ_ERR shows it once.
TEST(Faults, CanBeMasked) {
  Plc plc(ob(
      1,
      "CALL SFC 36 (PRGFLT_SET_MASK := DW#16#4000000, ACCFLT_SET_MASK := DW#16#4, RET_VAL := MW 0,"
      "PRGFLT_MASKED := MD 4, ACCFLT_MASKED := MD 8); L PEW 400; AUF DB 99;"
      "CALL SFC 38 (PRGFLT_QUERY := DW#16#4000000, ACCFLT_QUERY := DW#16#4, RET_VAL := MW 12,"
      "PRGFLT_CLR := MD 16, ACCFLT_CLR := MD 20);"
      "CALL SFC 38 (PRGFLT_QUERY := DW#16#4000000, ACCFLT_QUERY := DW#16#4, RET_VAL := MW 12,"
      "PRGFLT_CLR := MD 24, ACCFLT_CLR := MD 28);"));
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MD 16"), 0x04000000u);
  EXPECT_EQ(plc.read("MD 20"), 0x4u);
  EXPECT_EQ(plc.read("MD 24"), 0u);
  EXPECT_EQ(plc.read("MD 28"), 0u);
}

// S7-DIAG-01: a ring of 100.
TEST(Diagnostics, KeepTheNewestHundred) {
  Plc plc(ob(121, "") + ob(1, "AUF DB 99;"));
  plc.cycles(150);
  EXPECT_EQ(plc->diagnostics().size(), 100u);
  EXPECT_EQ(plc.lastEvent(), 0x253Au);
}

}  // namespace
}  // namespace merker::station::test
