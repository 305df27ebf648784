#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

// S7-STATE-03, S7-STATE-04, S7-BLK-15
TEST(Startup, Ob100RunsOnceBeforeOb1) {
  Plc plc(ob(100, "L 7; T MW 50; L MW 52; + 1; T MW 52;") + ob(1, "L MW 50; T MW 54;"));
  plc.cycles(3);
  EXPECT_EQ(plc.read("MW 54"), 7u);
  EXPECT_EQ(plc.read("MW 52"), 1u);
}

// S7-OBI-12: manual warm restart 81, the event of the last STOP 4303.
TEST(Startup, StartInformationOfOb100) {
  Plc plc(ob(100, "L LD 0; T MD 0; L LW 6; T MW 6;") + ob(1, ""));
  plc.cycles(1);
  plc->stop();
  EXPECT_TRUE(plc->warmRestart());
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MD 0"), 0x13811B64u);
  EXPECT_EQ(plc.read("MW 6"), 0x4303u);
}

// S7-OBI-12: bits 23..16 of STRT_INFO name the start.
TEST(Startup, StartInformationNamesTheStart) {
  Plc plc(ob(100, "L LD 8; T MD 10;") + ob(101, "L LD 8; T MD 10;") + ob(102, "L LD 8; T MD 10;") +
              ob(1, ""),
          *findCpuModel("generic"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x0003FF03u);
  plc->stop();
  EXPECT_TRUE(plc->hotRestart());
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x000BFF0Bu);
  EXPECT_TRUE(plc->coldRestart());
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x0007FF07u);
  plc->powerOff();
  plc->powerOn();
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x0010FF10u);
  plc->powerOff();
  plc->powerOn(false);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x0020FF20u);
}

// S7-OBI-12: bits 15..8 name the starts that are possible; the 314C has no hot restart.
TEST(Startup, StartInformationNamesThePossibleStarts) {
  Plc plc(ob(100, "L LD 8; T MD 10;") + ob(1, ""));
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 10"), 0x00037703u);
}

// S7-STATE-11: direct access works, its outputs come with RUN; no cycle monitoring, no interrupts.
TEST(Startup, HasNoMonitoringAndNoInterrupts) {
  Plc plc(
      ob(100, "L 1; T PAB 0; L 16; M001: T MW 60; CALL SFC 47 (WT := 25000); L MW 60; LOOP M001;") +
      ob(35, "L MW 70; + 1; T MW 70;") + ob(1, "L MW 70; T MW 72;"));
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_GE(plc->now().ns, 400'000'000);
  EXPECT_EQ(plc.read("MW 72"), 0u);
  EXPECT_EQ(plc.read("PAB 0"), 1u);
}

// S7-BLK-04, S7-OPEN-39
TEST(Startup, WithoutOb1IsRefused) {
  Plc plc(ob(100, "L 7; T MW 50;"));
  EXPECT_FALSE(plc->warmRestart());
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_NE(plc->stopReason().find("OB 1"), std::string::npos);
}

// S7-STATE-08, S7-DIAG-02
TEST(Startup, WritesItsEvents) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc->stop();
  std::vector<unsigned> events;
  for (const DiagnosticEntry& entry : plc->diagnostics()) events.push_back(entry.event);
  EXPECT_EQ(events, (std::vector<unsigned>{0x1381, 0x4301, 0x4302, 0x4303}));
  EXPECT_FALSE(plc->stoppedByFault());
}

// S7-STATE-10: memory reset ends force jobs.
TEST(MemoryReset, EndsForces) {
  Plc plc(ob(1, "U E 0.0; = A 4.0;"));
  plc.cycles(1);
  EXPECT_TRUE(plc.force("E 0.0", 1));
  EXPECT_EQ(plc->leds().frce, cpu::Light::On);
  plc->stop();
  plc->memoryReset();
  EXPECT_EQ(plc->leds().frce, cpu::Light::Off);
  plc.cycles(2);
  EXPECT_EQ(plc.read("A 4.0"), 0u);
}

// S7-STATE-10: in RUN it stops the CPU first.
TEST(MemoryReset, StopsTheCpu) {
  Plc plc(ob(1, "L MW 50; + 1; T MW 50;"));
  plc.cycles(3);
  plc->memoryReset();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc.countEvents(0x4304), 1u);
  plc->advanceTo(plc->now() + Duration::seconds(1));
  EXPECT_EQ(plc.read("MW 50"), 0u);
  plc->memoryReset();  // in STOP already
  EXPECT_EQ(plc.countEvents(0x4304), 1u);
}

// S7-STATE-06, S7-OPEN-43: the 314C has no cold restart.
TEST(ColdRestart, OnlyWhereTheModelHasIt) {
  Plc plc(ob(1, ""));
  EXPECT_FALSE(plc->coldRestart());
}

// S7-STATE-06, S7-MEM-04
TEST(ColdRestart, SetsEverythingBack) {
  Plc plc(
      "DATA_BLOCK DB 1\nSTRUCT\n a : INT := 3;\nEND_STRUCT;\nBEGIN\n a := 9;\nEND_DATA_BLOCK\n" +
          ob(102, "L LB 1; T MB 30;") + ob(1, "L LB 1; T MB 31;"),
      *findCpuModel("generic"));
  plc.cycles(1);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 9u);
  plc.write("MB 0", 5);
  plc.write("DB1.DBW 0", 77);
  plc->stop();
  EXPECT_TRUE(plc->coldRestart());
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MB 0"), 0u);
  EXPECT_EQ(plc.read("DB1.DBW 0"), 9u);  // as downloaded
  EXPECT_EQ(plc.read("MB 30"), 0x85u);
  EXPECT_EQ(plc.read("MB 31"), 4u);
}

// Whoever looks at values waits for the end of the cycle, but not for one that never comes.
TEST(Settle, WaitsNoLongerThanItMay) {
  Plc endless(ob(1, "m1: L MW 0; + 1; T MW 0; CALL SFC 43; SPA m1;"));
  endless.start();
  endless->advanceTo(endless->now() + Duration::milliseconds(20));
  const Instant before = endless->now();
  EXPECT_FALSE(endless->settle(Duration::milliseconds(5)));
  EXPECT_LT((endless->now() - before).ns, Duration::milliseconds(6).ns);
  endless->stop();
  EXPECT_TRUE(endless->settle(Duration::milliseconds(5)));
}

TEST(Settle, BetweenTwoCyclesNothingMoves) {
  Plc plc(ob(1, "L MW 0; + 1; T MW 0;"));
  plc.cycles(3);
  EXPECT_TRUE(plc->settle(Duration::seconds(1)));
  const Instant before = plc->now();
  EXPECT_TRUE(plc->settle(Duration::seconds(1)));
  EXPECT_EQ(plc->now().ns, before.ns);
  EXPECT_EQ(plc.read("MW 0"), 3u);
}

}  // namespace
}  // namespace merker::station::test
