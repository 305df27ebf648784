#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

// S7-BLK-03, S7-BLK-07, S7-STATE-01: OB 1 again and again, priority 1.
TEST(Cycle, Ob1RunsAgainAndAgain) {
  Plc plc("L MW 10; + 1; T MW 10; L LB 2; T MB 20;");
  plc.cycles(5);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MW 10"), 5u);
  EXPECT_EQ(plc->cycles(), 5u);
  EXPECT_EQ(plc.read("MB 20"), 1u);
}

// S7-CYCLE-02, S7-CYCLE-03: outputs are written, then inputs are read, then OB 1 runs; the image
// stays as it is.
TEST(Cycle, InputsAreTakenAtItsBegin) {
  Plc plc("U E 0.0; = A 4.0;");
  plc.cycles(1);
  plc.write("E 0.0", 1);
  EXPECT_EQ(plc.read("E 0.0"), 0u);  // the image, not the terminal
  EXPECT_EQ(plc.read("A 4.0"), 0u);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("E 0.0"), 1u);
  EXPECT_EQ(plc.read("A 4.0"), 1u);
  EXPECT_EQ(plc.read("PAB 4"), 0u);  // the terminal follows at the next cycle
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("PAB 4"), 1u);
}

// S7-OBI-02: OB1_SCAN_1 1 in the first cycle, then 3; the cycle times.
TEST(Cycle, StartInformationOfOb1) {
  Plc plc(
      "L LB 0; T MB 0; L LB 1; T MB 1; L LB 3; T MB 3; L LW 6; T MW 6; L LW 8; T MW 8; L LW 10; T "
      "MW 10;"
      "L LD 12; T MD 12;");
  plc.cycles(1);
  EXPECT_EQ(plc.read("MB 0"), 0x11u);
  EXPECT_EQ(plc.read("MB 1"), 1u);
  EXPECT_EQ(plc.read("MB 3"), 1u);
  EXPECT_EQ(plc.read("MD 12"), 0x90010100u);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MB 1"), 3u);
}

TEST(Cycle, KnowsItsTimes) {
  // 20 ms in the second cycle only
  Plc plc(
      "L MW 0; + 1; T MW 0; L 2; ==I; SPBN M001; CALL SFC 47 (WT := 20000); M001: L LW 6; T MW 6; "
      "L LW 8; T MW 8;"
      "L LW 10; T MW 10;");
  plc.cycles(5);
  EXPECT_EQ(plc.read("MW 6"), 0u);
  EXPECT_EQ(plc.read("MW 8"), 0u);
  EXPECT_EQ(plc.read("MW 10"), 20u);
}

// S7-CYCLE-06, S7-CPU-29, S7-DIAG-02, S7-DIAG-03
TEST(CycleMonitoring, WithoutOb80TheCpuStops) {
  Plc plc("M001: SPA M001;");
  plc.start();
  plc.run(Duration::milliseconds(149));
  EXPECT_EQ(plc->mode(),
            Mode::Stop);  // ran on to the end of its cycle, which is the end of its time
  EXPECT_EQ(plc.lastEvent(), 0x4568u);
  EXPECT_TRUE(plc.hasEvent(0x3501));
  EXPECT_TRUE(plc->stoppedByFault());
  EXPECT_GE(plc->now().ns, 150'000'000);
  EXPECT_LT(plc->now().ns, 150'001'000);
}

constexpr std::string_view kOb80 =
    "ORGANIZATION_BLOCK OB 80\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n"
    "L MW 100; + 1; T MW 100; L LD 0; T MD 104; L LD 8; T MD 108;\nEND_ORGANIZATION_BLOCK\n";

std::string withOb80(std::string_view body) {
  return std::string(kOb80) +
         "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\nEND_VAR\nBEGIN\n" +
         std::string(body) + "\nEND_ORGANIZATION_BLOCK\n";
}

// S7-OBI-07: FLT_ID 1, OB_NUM 1; S7-BLK-14
TEST(CycleMonitoring, CallsOb80) {
  Plc plc(withOb80("L 8; M001: T MW 0; CALL SFC 47 (WT := 25000); L MW 0; LOOP M001;"));  // 200 ms
  plc.cycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MW 100"), 1u);
  EXPECT_EQ(plc.read("MD 104"), 0x35011A50u);
  EXPECT_EQ(plc.read("MD 108") & 0xFFFF, 0x0101u);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MW 100"), 2u);
}

TEST(CycleMonitoring, TwiceInOneCycleStops) {
  Plc plc(withOb80("M001: SPA M001;"));
  plc.start();
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc.lastEvent(), 0x4568u);
  EXPECT_EQ(plc.read("MW 100"), 1u);
}

// S7-SFC-16: 400 ms with retriggering.
TEST(CycleMonitoring, CanBeRetriggered) {
  Plc plc("L 16; M001: T MW 0; CALL SFC 47 (WT := 25000); CALL SFC 43; L MW 0; LOOP M001;");
  plc.cycles(2);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_GE(plc->now().ns, 800'000'000);
}

// S7-STATE-02, S7-STATE-08, S7-SFC-18: the wish to stop is no fault; outputs are 0.
TEST(Stop, ByTheProgram) {
  Plc plc("SET; = A 4.0; U E 0.0; SPBN M001; CALL SFC 46; M001: NOP 0;");
  plc.cycles(3);
  EXPECT_EQ(plc.read("PAB 4"), 1u);
  plc.write("E 0.0", 1);
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_FALSE(plc->stoppedByFault());
  EXPECT_EQ(plc.lastEvent(), 0x457Fu);
  EXPECT_EQ(plc.read("PAB 4"), 0u);
  const Instant before = plc->now();
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc->now(), before + Duration::seconds(1));  // time goes on without a program
}

// S7-TMR-08, S7-TMR-20: exact in virtual time, whatever the cycle.
TEST(Timers, RunInVirtualTime) {
  Plc plc(
      "U E 0.0; L S5T#10S; SE T 1; U E 0.1; R T 1; L T 1; T MW 0; LC T 1; T MW 2; U T 1; = A 4.0;");
  plc.write("E 0.0", 1);
  plc.start();
  plc.run(Duration::milliseconds(2'650));
  EXPECT_EQ(plc.read("MW 0"), 74u);
  EXPECT_EQ(plc.read("MW 2"), 0x1074u);
  plc.run(Duration::milliseconds(7'340));
  EXPECT_EQ(plc.read("A 4.0"), 0u);
  plc.run(Duration::milliseconds(20));
  EXPECT_EQ(plc.read("A 4.0"), 1u);
  plc.write("E 0.1", 1);
  plc.run(Duration::milliseconds(2));
  EXPECT_EQ(plc.read("A 4.0"), 0u);
  EXPECT_EQ(plc.read("MW 2"), 0u);
}

// S7-CNT-10: the complete example.
TEST(Counters, ExampleOfTheCourse) {
  Plc plc(
      "U E 0.0; ZV Z 1; U E 0.1; ZR Z 1; U E 0.2; L C#25; S Z 1; U E 0.3; R Z 1; L Z 1; T MW 0; LC "
      "Z 1; T MW 2;"
      "U Z 1; = M 10.0;");
  plc.start();
  const auto pulse = [&](std::string_view input) {
    plc.write(input, 1), plc->advanceCycles(1), plc.write(input, 0), plc->advanceCycles(1);
  };
  for (int i = 0; i < 3; ++i) pulse("E 0.0");
  EXPECT_EQ(plc.read("MW 0"), 3u);
  EXPECT_EQ(plc.read("M 10.0"), 1u);
  pulse("E 0.1");
  EXPECT_EQ(plc.read("MW 0"), 2u);
  pulse("E 0.2");
  EXPECT_EQ(plc.read("MW 0"), 25u);
  EXPECT_EQ(plc.read("MW 2"), 0x0025u);
  pulse("E 0.3");
  EXPECT_EQ(plc.read("MW 0"), 0u);
  EXPECT_EQ(plc.read("M 10.0"), 0u);
}

// Measurements: OB 1 alone, back to back.
TEST(RunOb1, RunsOb1AndNothingElse) {
  Plc plc("L MW 10; + 1; T MW 10;");
  plc.cycles(1);
  const Instant before = plc->now();
  const std::uint64_t instructions = plc->instructions();
  for (int i = 0; i < 10; ++i) plc->runOb1();
  EXPECT_EQ(plc.read("MW 10"), 11u);
  EXPECT_EQ(plc->instructions() - instructions, 40u);
  EXPECT_EQ((plc->now() - before).ns, 10 * (200 + 2000 + 200 + 200));
}

TEST(RunOb1, GoesOnWhereItsTimeWasUp) {
  Plc endless("loop: L MW 10; + 1; T MW 10; SPA loop;");
  endless.start();
  endless->advanceToCheckpoint(endless->now() + Duration::seconds(1));
  EXPECT_FALSE(endless->runOb1(Duration::milliseconds(1)));
  const auto first = endless.read("MW 10");
  EXPECT_GT(first, 0u);
  EXPECT_FALSE(endless->runOb1(Duration::milliseconds(1)));
  EXPECT_GT(endless.read("MW 10"), first);
  EXPECT_EQ(endless->mode(), Mode::Run);
}

// S7-STATE-11: nothing ends a startup OB; a wish for cycles must.
TEST(Cycles, DoNotComeBehindAStartupThatDoesNotEnd) {
  Plc plc(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 100\nBEGIN\nloop: SPA loop;\nEND_ORGANIZATION_BLOCK\n");
  plc.cycles(1000);
  EXPECT_EQ(plc->cycles(), 0u);
  EXPECT_EQ(plc->mode(), Mode::Startup);
  EXPECT_LT(plc->now(), Instant{} + Duration::seconds(200));
}

TEST(Checkpoint, EndsEachStep) {
  Plc plc("L MW 10; + 1; T MW 10;");
  plc.start();
  const Instant limit = plc->now() + Duration::seconds(1);
  EXPECT_TRUE(plc->advanceToCheckpoint(limit));  // the change to RUN
  EXPECT_EQ(plc.read("MW 10"), 0u);
  EXPECT_TRUE(plc->advanceToCheckpoint(limit));
  EXPECT_EQ(plc.read("MW 10"), 1u);
  EXPECT_TRUE(plc->advanceToCheckpoint(limit));
  EXPECT_EQ(plc.read("MW 10"), 2u);
  EXPECT_FALSE(plc->advanceToCheckpoint(plc->now() + Duration::microseconds(10)));
}

// Two stations in one process, each alone; same inputs, same states.
TEST(Stations, KnowNothingOfEachOther) {
  constexpr std::string_view kAwl =
      "U E 0.0; L S5T#1S; SE T 1; U T 1; = A 4.0; L MW 10; + 1; T MW 10;";
  Plc one(kAwl), two(kAwl), other("L 5; T MW 10;");
  for (Plc* plc : {&one, &two}) {
    plc->write("E 0.0", 1);
    plc->start();
  }
  other.start();
  for (int i = 0; i < 30; ++i)
    for (Plc* plc : {&one, &two, &other}) plc->run(Duration::milliseconds(50));
  EXPECT_EQ(one.read("MW 10"), two.read("MW 10"));
  EXPECT_EQ(one->now(), two->now());
  EXPECT_EQ(one->instructions(), two->instructions());
  EXPECT_EQ(one.read("A 4.0"), 1u);
  EXPECT_EQ(other.read("MW 10"), 5u);
}

TEST(Stations, CanBeMoved) {
  Plc plc("L MW 10; + 1; T MW 10;");
  plc.start();
  Station moved = std::move(*plc);
  int seen = 0;
  moved.onCycle([&](controller::Controller& station) { seen += &station == &moved; });
  moved.advanceCycles(3);
  EXPECT_EQ(seen, 3);
}

TEST(Coverage, CountsEachInstruction) {
  const auto program =
      compileAwl("U E 0.0; SPB M001; L 5; T MW 0; M001: NOP 0;", defaultCpuModel());
  Station station({.program = program, .coverage = true});
  station.warmRestart();
  station.advanceCycles(3);
  const auto executed = station.executed();
  const auto& ob1 = executed.at({BlockKind::OB, 1});
  EXPECT_EQ(ob1.at(0), 3u);
  std::uint64_t sum = 0;
  for (const auto& [offset, count] : ob1) sum += count;
  EXPECT_EQ(sum, station.instructions());
}

}  // namespace
}  // namespace merker::station::test
