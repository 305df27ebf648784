#include "step5_plc.h"

namespace merker::monitor::test {
namespace {

std::string good(const std::optional<Problem>& problem) {
  return problem ? std::string(problem->name()) : "good";
}

// S7-STATE-07: HALT in front of the instruction, as on an S7 (docs/compatibility.md).
TEST(Step5Breakpoint, LeadsToHalt) {
  SinumerikPlc plc(kPress);
  const unsigned number = plc.breakAt("PB 5:17");
  plc.start();
  const Pause pause = plc.run();
  EXPECT_EQ(pause.why, Pause::Why::Breakpoint);
  EXPECT_EQ(pause.breakpoint, number);
  EXPECT_EQ(plc.control().mode(), controller::Mode::Halt);
  EXPECT_EQ(plc.where(), "PB 5:17");
  const Registers r = plc->registers();
  EXPECT_EQ(r.accu[0], 4u);
  EXPECT_EQ(r.accu[1], 5u);
  EXPECT_EQ(r.db, 10);
  EXPECT_FALSE(r.br || r.ar1 || r.di);
  EXPECT_EQ(plc.read("MW 110"), "W#16#0000");
}

// S5-BLK-10, S5-FB-06: by line, by word (also the second one of its instruction), by network.
TEST(Step5Breakpoint, StandsWhereItWasWritten) {
  for (const auto& [text, stands] : std::map<std::string, std::string>{{"press.s5:16", "PB 5:16"},
                                                                       {"16", "PB 5:16"},
                                                                       {"PB 5 word 3", "PB 5:16"},
                                                                       {"pb5 network 1", "PB 5:14"},
                                                                       {"FB 5:34", "FB 5:34"},
                                                                       {"OB 1", "OB 1:2"}}) {
    SinumerikPlc plc(kPress);
    plc.breakAt(text);
    plc.start();
    EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint) << text;
    EXPECT_EQ(plc.where(), stands) << text;
  }
}

TEST(Step5Breakpoint, GoesOnAndComesAgain) {
  SinumerikPlc plc(kPress);
  plc.breakAt("5");
  plc.start();
  for (int pass = 0; pass < 4; ++pass) {
    EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
    EXPECT_EQ(plc.read("MW 120", DisplayFormat::Dec), std::to_string(pass));
  }
  EXPECT_EQ(plc.debugger().breakpoints().front().hits, 4u);
}

TEST(Step5Breakpoint, CanBeSwitchedOffAndTakenAway) {
  SinumerikPlc plc(kPress);
  const unsigned number = plc.breakAt("PB 5 word 2");
  EXPECT_EQ(plc.breakAt("16"), number);  // the same place
  plc.start();
  EXPECT_TRUE(plc.debugger().enableBreakpoint(number, false));
  EXPECT_EQ(plc.run().why, Pause::Why::Limit);
  EXPECT_EQ(plc.breakAt("PB 5:16"), number);  // set once more: it is on again
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_TRUE(plc.debugger().removeBreakpoint(number));
  EXPECT_EQ(plc.run().why, Pause::Why::Limit);
  EXPECT_TRUE(plc.control().plc().probes().empty());  // it runs at full speed again
}

// S5-OB-01, S5-OB-05
TEST(Step5Breakpoint, StandsInStartUpAndAlarmLevel) {
  SinumerikPlc plc(
      "OB 1\n : BE\nOB 20\n : L KH 1234\n : T MW 150\n : BE\nOB 2\n : L KF +2\n : BE\n");
  plc.breakAt("OB 20:5");
  plc.breakAt("OB 2");
  plc.start();
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_EQ(plc.where(), "OB 20:5");
  EXPECT_EQ(plc->registers().accu[0], 0x1234u);
  EXPECT_EQ(plc->stacks().interrupts.front().ob, 20);
  EXPECT_EQ(plc.run().why, Pause::Why::Limit);
  EXPECT_EQ(good(plc->write("E 7.0", "1")), "good");
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_EQ(plc.where(), "OB 2:8");
  EXPECT_EQ(plc->stacks().interrupts.front().ob, 2);
}

// S5-PROC-01: B and what it processes are one instruction; a breakpoint at either stands at B.
TEST(Step5Breakpoint, StandsBeforeASubstitution) {
  for (const char* text : {"16", "FB 6:17", "FB 6 word 13"}) {
    SinumerikPlc plc(kLoop);
    plc.breakAt(text);
    plc.start();
    EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint) << text;
    EXPECT_EQ(plc.where(), "FB 6:16") << text;
    plc.step();
    EXPECT_EQ(plc.where(), "FB 6:18");
  }
}

// S7-STATE-07: neither what the program does nor its time depends on who looked.
TEST(Step5Breakpoint, ChangesNothing) {
  SinumerikPlc watched(kPress), plain(kPress);
  watched.breakAt("PB 5:17");
  watched.start();
  plain.start();
  for (int i = 0; i < 5; ++i) watched.run();
  for (int i = 0; i < 20; ++i) watched.step();
  watched.debugger().removeBreakpoints();
  const Instant end{1'000'000'000};
  watched.debugger().run(end);
  plain.debugger().run(end);
  EXPECT_EQ(watched.control().instructions(), plain.control().instructions());
  EXPECT_EQ(watched.read("MW 120"), plain.read("MW 120"));
  EXPECT_EQ(watched.control().now(), plain.control().now());
}

TEST(Step5Step, GoesIntoCalls) {
  SinumerikPlc plc(kPress);
  plc.breakAt("6");
  plc.start();
  plc.run();
  plc.expectSteps(StepKind::Into, {"FB 5:34", "FB 5:35", "FB 5:36", "OB 1:9", "PB 5:14"});
}

// A step over the last statement of OB 1 ends in the next cycle.
TEST(Step5Step, GoesOverCallsAndCycles) {
  SinumerikPlc plc(kPress);
  plc.breakAt("6");
  plc.start();
  plc.run();
  plc.debugger().removeBreakpoints();
  plc.expectSteps(StepKind::Over, {"OB 1:9", "OB 1:10", "OB 1:11", "OB 1:12"});
  EXPECT_EQ(plc.control().cycles(), 0u);
  plc.expectSteps(StepKind::Over, {"OB 1:2"});
  EXPECT_EQ(plc.control().cycles(), 1u);
}

TEST(Step5Step, GoesOutOfBlocks) {
  SinumerikPlc plc(kPress);
  plc.breakAt("PB 5:15");
  plc.start();
  plc.run();
  plc.debugger().removeBreakpoints();
  plc.expectSteps(StepKind::Out, {"OB 1:10", "OB 1:2"});
  EXPECT_EQ(plc.control().cycles(), 1u);
}

// BEB with VKE 1 ends its block, BEA always; the step ends in the caller.
TEST(Step5Step, LeavesBlocksByTheirEnds) {
  SinumerikPlc plc(
      "OB 1\n : SPA PB 1\n : SPA PB 2\n : BE\nPB 1\n : O M 200.0\n : ON M 200.0\n"
      " : BEB\n : NOP 0\n : BE\nPB 2\n : BEA\n : NOP 0\n : BE\n");
  plc.breakAt("2");
  plc.start();
  plc.run();
  plc.expectSteps(StepKind::Into, {"PB 1:6", "PB 1:7", "PB 1:8", "OB 1:3", "PB 2:12", "OB 1:4"});
}

// S5-PROC-01: a loop, a substituted operand, and one machine instruction each.
TEST(Step5Step, FollowsJumpsAndSubstitutions) {
  SinumerikPlc plc(kLoop);
  plc.breakAt("15");
  plc.start();
  plc.run();
  plc.expectSteps(StepKind::Instruction, {"FB 6:9", "FB 6:10"});
  plc.run();
  plc.run();
  EXPECT_EQ(plc.debugger().breakpoints().front().hits, 3u);
  plc.expectSteps(StepKind::Instruction, {"FB 6:16", "FB 6:18", "FB 6:19"});
  plc.expectSteps(StepKind::Over, {"FB 6:20", "OB 1:4"});
}

TEST(Step5Step, EndsWithTheAlarm) {
  SinumerikPlc plc(kPress);
  plc.breakAt("26");
  plc.start();
  EXPECT_EQ(good(plc->write("E 0.7", "1")), "good");
  EXPECT_EQ(plc.run().why, Pause::Why::Breakpoint);
  EXPECT_EQ(plc.step().why, Pause::Why::Stop);
  EXPECT_EQ(plc.where(), "PB 6:26");
  EXPECT_TRUE(plc.control().stoppedByFault());
}

// S5-ERR-09: an alarm level that comes between does not catch the step.
TEST(Step5Step, StaysInItsLevel) {
  SinumerikPlc plc(kInterrupted);
  plc.breakAt("FB 1:7");
  plc.start();
  plc.run();
  plc.debugger().removeBreakpoints();
  EXPECT_EQ(good(plc->write("E 7.0", "1")), "good");
  int steps = 0;
  for (; steps < 50'000 && plc.read("MW 130", DisplayFormat::Dec) == "0"; ++steps) {
    plc.step();
    ASSERT_TRUE(plc.where().starts_with("FB 1")) << plc.where();
  }
  EXPECT_EQ(plc.read("MW 130", DisplayFormat::Dec), "1");
}

std::string shown(const ProgramStatus& status) {
  std::string text;
  for (const StatusRow& row : status.rows()) text += !row.reached ? '-' : row.after.rlo ? '1' : '0';
  return text;
}

// S7-EDIT-21 for STEP 5: accumulators, data block, displays; BEB shows what it found.
TEST(Step5Status, ShowsRegistersAfterEachLine) {
  SinumerikPlc plc(kPress);
  EXPECT_TRUE(plc.debugger().showStatus({BlockKind::PB, 5}));
  plc.start();
  EXPECT_EQ(good(plc->write("E 0.6", "1")), "good");
  plc.control().advanceCycles(2);
  const auto rows = plc.debugger().status()->rows();
  ASSERT_EQ(rows.size(), 10u);
  EXPECT_EQ(rows[0].after.db, 10);
  EXPECT_EQ(rows[1].after.accu[0], 5u);
  EXPECT_EQ(rows[2].after.accu[0], 4u);
  EXPECT_EQ(rows[2].after.accu[1], 5u);
  EXPECT_EQ(rows[3].after.accu[0], 9u);
  EXPECT_TRUE(rows[3].after.cc1);  // positive
  EXPECT_TRUE(rows[5].after.rlo && rows[5].after.sta);
  EXPECT_EQ(rows[6].after.db, 10);
  EXPECT_EQ(shown(*plc.debugger().status()).substr(5), "11---");
  EXPECT_EQ(good(plc->write("E 0.6", "0")), "good");
  plc.control().advanceCycles(2);
  EXPECT_TRUE(plc.debugger().status()->rows()[9].reached);
  EXPECT_EQ(plc.debugger().status()->calls(), 4u);
}

// A call shows what it left behind: OS, ODER and ERAB are 0 after it (OP-24).
TEST(Step5Status, ShowsCallsAfterTheirReturn) {
  SinumerikPlc plc(kPress);
  plc.debugger().showStatus({BlockKind::OB, 1});
  plc.start();
  plc.control().advanceCycles(1);
  const auto rows = plc.debugger().status()->rows();
  EXPECT_EQ(rows[4].statement.line, 6u);
  EXPECT_EQ(rows[5].statement.line, 9u);
  EXPECT_EQ(rows[5].after.accu[0], 7u);  // of PB 5
  EXPECT_EQ(rows[5].after.db, 0);        // the data block of the caller (S5-DB-07)
}

// Loops show their last pass; B shows what it found, the next line what it processed.
TEST(Step5Status, ShowsLoopsAndSubstitutions) {
  SinumerikPlc plc(kLoop);
  plc.debugger().showStatus({BlockKind::FB, 6});
  EXPECT_EQ(good(plc->write("EB 1", "7")), "good");
  plc.start();
  EXPECT_EQ(good(plc->write("MW 104", "1")), "good");
  plc.control().advanceCycles(2);
  const auto rows = plc.debugger().status()->rows();
  ASSERT_EQ(rows.size(), 16u);
  EXPECT_EQ(rows[5].passes, 3u);
  EXPECT_EQ(rows[5].after.accu[0], 0u);
  EXPECT_TRUE(rows[9].reached && rows[10].reached);
  EXPECT_EQ(rows[9].statement.line, 16u);
  EXPECT_EQ(rows[9].after.accu[0], 0u);
  EXPECT_EQ(rows[10].after.accu[0], 7u);  // EB 1
  EXPECT_EQ(rows[10].passes, 1u);
  EXPECT_FALSE(rows[14].reached);  // behind BEB
}

// Only calls of the chosen caller, or with this data block.
TEST(Step5Status, LooksAtTheChosenCalls) {
  const char* const text =
      "OB 1\n : A DB 10\n : SPA PB 1\n : A DB 11\n : SPA PB 2\n : BE\nPB 1\n : L DW 0\n : BE\n"
      "PB 2\n : SPA PB 1\n : BE\nDB 10\n 0 : KF = +10\nDB 11\n 0 : KF = +11\n";
  for (const auto& [environment, seen] :
       {std::pair{CallEnvironment{.caller = BlockId{BlockKind::OB, 1}, .db = {}, .di = {}}, 10u},
        {CallEnvironment{.caller = BlockId{BlockKind::PB, 2}, .db = {}, .di = {}}, 11u},
        {CallEnvironment{.caller = {}, .db = 10, .di = {}}, 10u},
        {CallEnvironment{.caller = {}, .db = 11, .di = {}}, 11u}}) {
    SinumerikPlc plc(text);
    plc.debugger().showStatus({BlockKind::PB, 1}, environment);
    plc.start();
    plc.control().advanceCycles(3);
    EXPECT_EQ(plc.debugger().status()->calls(), 3u);
    EXPECT_EQ(plc.debugger().status()->rows()[0].after.accu[0], seen);
  }
}

}  // namespace
}  // namespace merker::monitor::test
