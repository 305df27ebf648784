#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

// S7-BLK-05, S7-BLK-10, S7-OBI-05: every 100 ms, priority 12.
TEST(CyclicInterrupt, ComesEvery100Milliseconds) {
  Plc plc(ob(35, "L MW 0; + 1; T MW 0; L LD 0; T MD 4; L LW 10; T MW 8;") + ob(1, ""));
  plc.start();
  plc.run(Duration::milliseconds(99));
  EXPECT_EQ(plc.read("MW 0"), 0u);
  plc.run(Duration::milliseconds(2));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  plc.run(Duration::milliseconds(900));
  EXPECT_EQ(plc.read("MW 0"), 10u);
  EXPECT_EQ(plc.read("MD 4"), 0x11360C23u);
  EXPECT_EQ(plc.read("MW 8"), 100u);
}

// S7-CYCLE-04, S7-REG-05, S7-OPND-03: inside a long OB 1, which notices nothing.
TEST(CyclicInterrupt, DoesNotDisturbOb1) {
  Plc plc(ob(35, "L 4711; T #x; LAR1 P#3.0; LAR2 P#4.0; AUF DB 2; SET; L MW 0; + 1; T MW 0;") +
          "DATA_BLOCK DB 1\nSTRUCT\n a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
          "DATA_BLOCK DB 2\nSTRUCT\n a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" +
          ob(1,
             "L MW 20; L 0; <>I; SPB M009;"
             "AUF DB 1; LAR1 P#1.0; L 5; T #x; L W#16#1234; L 0; CLR;"
             "M001: L MW 0; L 1; <I; SPB M001;"  // until OB 35 has run
             "L DBNO; T MW 22; L #x; T MW 24; TAR1; T MD 26; L 1; T MW 20;"
             "M009: NOP 0;"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 0"), 1u);
  EXPECT_EQ(plc.read("MW 22"), 1u);
  EXPECT_EQ(plc.read("MW 24"), 5u);
  EXPECT_EQ(plc.read("MD 26"), 8u);
}

// At an instruction boundary: the instruction that is running ends first, the clock says when.
TEST(CyclicInterrupt, BeginsAtTheFirstBoundary) {
  Plc plc(ob(35, "CALL SFC 64 (RET_VAL := MD 4); L 1; T MW 0;") +
          ob(1, "M001: L MW 0; L 1; <I; SPB M001;"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 4"), 100u);
}

// S7-OBI-07: FLT_ID 2, the requested OB is still running.
TEST(CyclicInterrupt, TooLongCallsOb80) {
  const std::string slow =
      ob(35,
         "L MW 0; L 0; <>I; BEB; L 1; T MW 0; L 5; M001: T MW 2; CALL SFC 47 (WT := 25000);"
         "CALL SFC 43; L MW 2; LOOP M001;");
  Plc stops(slow + ob(1, ""));
  stops.start();
  stops.run(Duration::milliseconds(300));
  EXPECT_EQ(stops.lastEvent(), 0x4568u);
  EXPECT_TRUE(stops.hasEvent(0x3502));

  Plc handled(slow + ob(80, "L LW 0; T MW 10; L LW 10; T MW 12;") + ob(1, ""));
  handled.start();
  handled.run(Duration::milliseconds(400));
  EXPECT_EQ(handled->mode(), Mode::Run);
  EXPECT_EQ(handled.read("MW 10"), 0x3502u);
  EXPECT_EQ(handled.read("MW 12"), 0x0C23u);
}

// S7-SFC-13, S7-BLK-09, S7-OBI-04
TEST(DelayInterrupt, ComesOnceAndCanBeCancelled) {
  Plc plc(ob(20, "L MW 0; + 1; T MW 0; L LD 0; T MD 4; L LW 6; T MW 8; L LD 8; T MD 10;") +
          ob(1,
             "U E 0.0; FP M 20.0; SPBN M001; CALL SFC 32 (OB_NR := 20, DTIME := T#100MS, SIGN := "
             "W#16#4711,"
             "RET_VAL := MW 30); M001: U E 0.1; FP M 20.1; SPBN M002; CALL SFC 33 (OB_NR := 20, "
             "RET_VAL := MW 32);"
             "M002: CALL SFC 34 (OB_NR := 20, RET_VAL := MW 34, STATUS := MW 36);"));
  plc.start();
  plc.run(Duration::milliseconds(5));
  EXPECT_EQ(plc.read("MW 36"), 0x10u);
  plc.write("E 0.0", 1);
  plc.run(Duration::milliseconds(50));
  EXPECT_EQ(plc.read("MW 36"), 0x14u);
  plc.run(Duration::milliseconds(60));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  EXPECT_EQ(plc.read("MD 4"), 0x11210314u);
  EXPECT_EQ(plc.read("MW 8"), 0x4711u);
  EXPECT_EQ(plc.read("MD 10"), 100u);
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  plc.write("E 0.0", 0);
  plc.run(Duration::milliseconds(5));
  plc.write("E 0.0", 1);
  plc.run(Duration::milliseconds(5));
  plc.write("E 0.1", 1);
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  EXPECT_EQ(plc.read("MW 32"), 0u);
}

// S7-SFC-12, S7-BLK-08, S7-OBI-03
TEST(TimeOfDayInterrupt, ComesEveryMinute) {
  Plc plc(ob(10, "L MW 0; + 1; T MW 0; L LD 0; T MD 4; L LW 6; T MW 8;") +
          "DATA_BLOCK DB 1\nSTRUCT\n t : DATE_AND_TIME := "
          "DT#1990-01-01-00:00:00.000;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" +
          ob(100,
             "CALL SFC 28 (OB_NR := 10, SDT := DB1.t, PERIOD := W#16#0201, RET_VAL := MW 30);"
             "CALL SFC 30 (OB_NR := 10, RET_VAL := MW 32);") +
          ob(1, ""));
  plc.start();
  plc.run(Duration::milliseconds(59'900));
  EXPECT_EQ(plc.read("MW 30"), 0u);
  EXPECT_EQ(plc.read("MW 32"), 0u);
  EXPECT_EQ(plc.read("MW 0"), 0u);
  plc.run(Duration::milliseconds(200));
  EXPECT_EQ(plc.read("MW 0"), 1u);
  EXPECT_EQ(plc.read("MD 4"), 0x1111020Au);
  EXPECT_EQ(plc.read("MW 8"), 0x0201u);
  plc.run(Duration::seconds(120));
  EXPECT_EQ(plc.read("MW 0"), 3u);
}

// S7-SFC-15: delayed between 41 and 42, then run.
TEST(Interrupts, CanBeDelayed) {
  Plc plc(ob(35, "L 1; T MW 0;") +
          ob(1,
             "CALL SFC 41 (RET_VAL := MW 30); L 5; M001: T MW 2; CALL SFC 47 (WT := 25000); L MW "
             "2; LOOP M001;"
             "L MW 0; T MW 4; CALL SFC 42 (RET_VAL := MW 32); L MW 0; T MW 6;"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 4"), 0u);
  EXPECT_EQ(plc.read("MW 6"), 1u);
  EXPECT_EQ(plc.read("MW 30"), 1u);
  EXPECT_EQ(plc.read("MW 32"), 0u);
}

// S7-SFC-15: locked interrupts are lost.
TEST(Interrupts, CanBeLocked) {
  Plc plc(
      ob(35, "L MW 0; + 1; T MW 0;") +
      ob(1,
         "U E 0.0; SPB M001; CALL SFC 39 (MODE := B#16#2, OB_NR := 35, RET_VAL := MW 30); SPA M002;"
         "M001: CALL SFC 40 (MODE := B#16#2, OB_NR := 35, RET_VAL := MW 30); M002: NOP 0;"));
  plc.start();
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc.read("MW 0"), 0u);
  plc.write("E 0.0", 1);
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc.read("MW 0"), 10u);
}

}  // namespace
}  // namespace merker::station::test
