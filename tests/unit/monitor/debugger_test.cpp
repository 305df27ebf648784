#include <gtest/gtest.h>

#include "interpreter/translated.h"
#include "plc.h"

namespace merker::monitor::test {
namespace {

// S7-STATE-07, S7-EDIT-22: HALT in front of the instruction, registers shown.
TEST(Breakpoint, LeadsToHalt) {
  Plc plc(kProgram);
  const unsigned number = plc.breakAt("FC 1:12");
  plc.start();
  EXPECT_EQ(name(plc->write("MW 10", "37")), "good");
  const Pause pause = plc.run();
  EXPECT_EQ(pause.why, Pause::Why::Breakpoint);
  EXPECT_EQ(pause.breakpoint, number);
  EXPECT_EQ(plc.station().mode(), station::Mode::Halt);
  EXPECT_EQ(plc.where(), "FC 1:12");
  const cpu::Registers& r = plc.station().cpu().machine().registers;
  EXPECT_EQ(r.accu[0], 5u);
  EXPECT_EQ(r.accu[1], 37u);
  EXPECT_EQ(plc.read("MW 12", DisplayFormat::Dec), "0");
}

// S7-STATE-07, S7-DIAG-01: the entry 16#4305 names the place of the HALT.
TEST(Breakpoint, IsThePlaceOfTheEntry) {
  Plc plc(kProgram);
  plc.breakAt("FC 1:12");
  plc.start();
  plc.run();
  const auto entry = plc->diagnostics().front();
  EXPECT_EQ(entry.event, 0x4305);
  ASSERT_TRUE(entry.place.has_value());
  EXPECT_EQ(*entry.place, *plc.debugger().position());
  EXPECT_EQ(entry.place->line, 12u);
}

// S7-STATE-07: a step that comes back to HALT is no event; docs/compatibility.md.
TEST(Step, WritesNothingIntoTheDiagnosticBuffer) {
  Plc plc(kProgram);
  plc.breakAt("FC 1:12");
  plc.start();
  plc.run();
  const auto added = plc->diagnosticsAdded();
  for (int i = 0; i < 3; ++i) plc.step(StepKind::Over);
  EXPECT_EQ(plc.station().mode(), station::Mode::Halt);
  EXPECT_EQ(plc->diagnosticsAdded(), added);
  plc.debugger().removeBreakpoints();
  plc.run();
  EXPECT_EQ(plc->diagnostics().front().event, 0x4306);
}

// S7-STATE-07: one stop per pass; the instruction is executed once.
TEST(Breakpoint, GoesOnAndComesAgain) {
  Plc plc(kProgram);
  plc.breakAt("22");
  plc.start();
  for (int pass = 0; pass < 4; ++pass) {
    EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
    EXPECT_EQ(plc.read("MW 20", DisplayFormat::Dec), std::to_string(pass));
  }
  EXPECT_EQ(plc.debugger().breakpoints().front().hits, 4u);
}

TEST(Breakpoint, CanBeSwitchedOffAndTakenAway) {
  Plc plc(kProgram);
  const unsigned number = plc.breakAt("22");
  EXPECT_EQ(plc.breakAt("22"), number);
  plc.start();
  EXPECT_TRUE(plc.debugger().enableBreakpoint(number, false));
  EXPECT_EQ(plc.run().why, Pause::Why::Limit);
  EXPECT_TRUE(plc.debugger().enableBreakpoint(number, true));
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_TRUE(plc.debugger().enableBreakpoint(number, false));
  EXPECT_EQ(plc.breakAt("22"), number);  // set once more: it is on again
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_TRUE(plc.debugger().removeBreakpoint(number));
  EXPECT_FALSE(plc.debugger().removeBreakpoint(number));
  EXPECT_EQ(plc.run().why, Pause::Why::Limit);
}

// S7-STATE-07: timers stand still in HALT, however long it lasts.
TEST(Breakpoint, FreezesTimers) {
  Plc plc(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n UN M 1.0;\n L S5T#2S;\n SE T 1;\n NOP 0;\n"
      "END_ORGANIZATION_BLOCK\n");
  plc.breakAt("7");
  plc.start();
  plc.run();
  const std::string before = plc.read("T 1");
  plc.station().advanceTo(plc.station().now() + Duration::seconds(5));
  EXPECT_EQ(plc.station().mode(), station::Mode::Halt);
  EXPECT_EQ(plc.read("T 1"), before);
  plc.debugger().removeBreakpoints();
  plc.debugger().run(plc.soon());
  EXPECT_NE(plc.read("T 1"), before);
  EXPECT_NE(plc.read("T 1"), "S5T#0MS");
}

// S7-STATE-07: neither what the program does nor its time depends on who looked.
TEST(Breakpoint, ChangesNothing) {
  Plc watched(kProgram), plain(kProgram);
  watched.breakAt("FC 1:12");
  watched.start();
  plain.start();
  for (int i = 0; i < 5; ++i) watched.run();
  for (int i = 0; i < 20; ++i) watched.step();
  watched.debugger().removeBreakpoints();
  const Instant end{1'000'000'000};
  watched.debugger().run(end);
  plain.debugger().run(end);
  EXPECT_EQ(watched.station().instructions(), plain.station().instructions());
  EXPECT_EQ(watched.read("MW 20"), plain.read("MW 20"));
  EXPECT_EQ(watched.station().now(), plain.station().now());
}

// S7-EDIT-21, S7-EDIT-22: what the last statement did can be looked at before its block is left.
TEST(Step, StopsAtTheEndOfABlock) {
  Plc plc(kProgram);
  plc.breakAt("FC 1:15");
  plc.start();
  EXPECT_EQ(name(plc->write("MW 10", "37")), "good");
  plc.run();
  plc.step();
  const auto place = plc.debugger().position();
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE(endsBlock(plc.program().at(place->block), place->offset));
  EXPECT_EQ(plc.read("MW 12", DisplayFormat::Dec), "42");
  plc.step();
  EXPECT_EQ(plc.where(), "OB 1:24");
}

// S7-EDIT-22
TEST(Step, GoesIntoCalls) {
  Plc plc(kProgram);
  plc.breakAt("23");
  plc.start();
  plc.run();
  for (const char* expected : {"FC 1:10", "FC 1:11", "FC 1:12", "FC 1:14", "FC 1:15"}) {
    EXPECT_EQ(plc.step().why, Pause::Why::Step);
    EXPECT_EQ(plc.where(), expected);
  }
  while (plc.where().starts_with("FC")) plc.step();
  EXPECT_EQ(plc.where(), "OB 1:24");
}

TEST(Step, GoesOverCalls) {
  Plc plc(kProgram);
  plc.breakAt("23");
  plc.start();
  plc.run();
  EXPECT_EQ(plc.step(StepKind::Over).why, Pause::Why::Step);
  EXPECT_EQ(plc.where(), "OB 1:24");
  plc.step(StepKind::Over);
  plc.step(StepKind::Over);
  EXPECT_EQ(plc.where(), "OB 1:27");
}

TEST(Step, GoesOutOfBlocks) {
  Plc plc(kProgram);
  plc.breakAt("FC 1:11");
  plc.start();
  plc.run();
  plc.step(StepKind::Out);
  EXPECT_EQ(plc.where(), "OB 1:24");
  plc.debugger().removeBreakpoints();
  plc.step(StepKind::Out);  // the OB ends: the next cycle
  EXPECT_EQ(plc.where(), "OB 1:20");
  EXPECT_EQ(plc.station().cycles(), 1u);
}

TEST(Step, StopsAtABreakpointOnItsWay) {
  Plc plc(kProgram);
  plc.breakAt("23");
  plc.breakAt("FC 1:12");
  plc.start();
  plc.run();
  const Pause pause = plc.step(StepKind::Over);
  EXPECT_EQ(pause.why, Pause::Why::Breakpoint);
  EXPECT_EQ(plc.where(), "FC 1:12");
}

// An interrupt that comes between does not catch the step; the error OB of its own fault does.
TEST(Step, StaysInItsPriorityClass) {
  const std::string obs =
      "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\n L MW 30;\n + 1;\n T MW 30;\n"
      "END_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 121\nBEGIN\nNETWORK\n NOP 0;\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n"
      "here: CALL SFC 47 (WT := 20000);\n L MW 30;\n L 1;\n >=I;\n SPBN here;\n AUF DB 9;\n NOP "
      "0;\n"
      "END_ORGANIZATION_BLOCK\n";
  Plc plc(obs);
  plc.start();
  bool errorOb = false;
  for (int i = 0; i < 300 && !errorOb; ++i) {
    plc.debugger().step(StepKind::Into, plc.soon());
    EXPECT_FALSE(plc.where().starts_with("OB 35"));
    errorOb = plc.where().starts_with("OB 121");
  }
  EXPECT_TRUE(errorOb);
  EXPECT_EQ(plc.read("MW 30", DisplayFormat::Dec), "1");
}

// Where nobody looks any more the program runs at full speed again.
TEST(Step, LeavesNoProbeBehind) {
  Plc plc(kProgram);
  plc.start();
  plc.step();
  for (const auto& code : plc.station().cpu().loadMemory().code())
    EXPECT_EQ(static_cast<const interpreter::Translated&>(*code).probe, nullptr);
}

TEST(Step, EndsWithTheCpu) {
  Plc plc(kProgram);
  plc.breakAt("26");
  plc.start();
  EXPECT_EQ(name(plc->write("M 0.0", "1")), "good");
  plc.run();
  EXPECT_EQ(plc.where(), "OB 1:26");
  EXPECT_EQ(plc.step().why, Pause::Why::Stop);
  EXPECT_EQ(plc.where(), "OB 1:26");
  EXPECT_TRUE(plc.station().stoppedByFault());
}

// S7-SIM-13: a single scan is exactly one cycle.
TEST(Run, SingleCycle) {
  Plc plc(kProgram);
  plc.start();
  plc.debugger().runToCheckpoint(plc.soon());  // to RUN
  for (std::uint64_t i = 1; i <= 3; ++i) {
    plc.debugger().runToCheckpoint(plc.soon());
    EXPECT_EQ(plc.station().cycles(), i);
    EXPECT_EQ(plc.read("MW 20", DisplayFormat::Dec), std::to_string(i));
  }
}

TEST(Run, CanBeInterrupted) {
  Plc plc(kProgram);
  plc.start();
  EXPECT_EQ(plc.debugger().run(plc.soon(), [] { return true; }).why, Pause::Why::Interrupted);
  EXPECT_LT(plc.station().now(), Instant{500'000'000});
}

}  // namespace
}  // namespace merker::monitor::test
