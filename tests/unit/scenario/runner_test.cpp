#include "scenario/runner.h"

#include <gtest/gtest.h>

#include "machine.h"

namespace merker::simulator {
namespace {

// A 0.0 follows E 0.0; A 0.1 comes 2 s after it; MW 20 counts cycles; E 0.7 divides by reading a DB
// that is not there.
constexpr const char* kProgram = R"(
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     E 0.0
      =     A 0.0
      L     S5T#2S
      SE    T 1
      U     T 1
      =     A 0.1
      L     MW 20
      +     1
      T     MW 20
      UN    E 0.7
      SPB   good
      L     W#16#FFFF
      BTI
good: NOP 0
END_ORGANIZATION_BLOCK
)";

std::string failure(const TestResult& result) {
  if (result.failures.size() != 1) return std::to_string(result.failures.size()) + " failures";
  return std::to_string(result.failures[0].position.line) + ": " + result.failures[0].message;
}

TEST(Runner, InputsReachTheProgramWithTheNextCycle) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run(
                "set E 0.0 = 1\nwait 2 cycles\nexpect A 0.0 = 1\nset E 0.0 = 0\nexpect A 0.0 = 1\n"
                "wait 2 cycles\nexpect A 0.0 = 0\n")),
            "0 failures");
}

TEST(Runner, AFailureSaysWhatWasExpectedAndWhatWasThere) {
  const Machine machine(kProgram);
  const TestResult result = machine.run("wait 1s\nexpect A 0.0 = 1   # never\nexpect A 0.1 = 1\n");
  EXPECT_EQ(failure(result), "2: expected A 0.0 = 1, A 0.0 is 0");
  EXPECT_GE(result.failures[0].time, Instant{1'000'000'000});
}

TEST(Runner, ForHoldsDuringTheWholeTime) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("set E 0.0 = 1\nwait 2 cycles\nexpect A 0.1 = 0 for 1.9s\n")),
            "0 failures");
  const TestResult late = machine.run("set E 0.0 = 1\nwait 2 cycles\nexpect A 0.1 = 0 for 2.1s\n");
  EXPECT_EQ(failure(late), "3: expected A 0.1 = 0 for 2.1s, A 0.1 is 1");
  EXPECT_NEAR(static_cast<double>(late.failures[0].time.ns) / 1e9, 2.0, 0.02);
}

TEST(Runner, WithinGoesOnFromTheMomentItHolds) {
  const Machine machine(kProgram);
  const TestResult result = machine.run("set E 0.0 = 1\nexpect A 0.1 = 1 within 10s\n");
  EXPECT_EQ(failure(result), "0 failures");
  EXPECT_NEAR(static_cast<double>(result.end.ns) / 1e9, 2.0, 0.02);
  const TestResult never = machine.run("expect A 0.1 = 1 within 1s\n");
  EXPECT_EQ(failure(never), "1: expected A 0.1 = 1 within 1s, A 0.1 is 0");
  EXPECT_GE(never.end, Instant{1'000'000'000});
  EXPECT_LT(never.end, Instant{1'020'000'000});
}

TEST(Runner, WaitsForCycles) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("set MW 20 = 0\nwait 5 cycles\nexpect MW 20 = 5\nrepeat 3\nwait 1 "
                                "cycle\nend\nexpect MW 20 = 8\n")),
            "0 failures");
}

TEST(Runner, ModesAndRestarts) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run(
                "expect mode = RUN\nstop\nexpect mode = STOP\nwait 1s\nexpect mode = STOP for 1s\n"
                "run\nexpect mode = RUN\nwarm restart\nexpect mode = RUN\nmemory reset\n"
                "expect mode = STOP\nrun\nexpect mode = RUN\n")),
            "0 failures");
}

TEST(Runner, PowerOffAndOnKeepsRetentiveFlags) {  // S7-CPU-28
  const Machine machine(kProgram);
  EXPECT_EQ(
      failure(machine.run(
          "set MB 15 = 7, MB 100 = 7\nwait 2 cycles\npower off\nwait 1s\npower on\nwait 2 cycles\n"
          "expect mode = RUN\nexpect MB 15 = 7\nexpect MB 100 = 0\n")),
      "0 failures");
}

TEST(Runner, TheModel314HasNoColdRestart) {  // S7-OPEN-43
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("cold restart\n")),
            "1: cold restart: the CPU refuses: CPU 314C-2 PtP has no cold restart");
}

TEST(Runner, ForcedOperandsKeepTheirValue) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run(
                "force E 0.0 = 1\nwait 2 cycles\nset E 0.0 = 0\nwait 2 cycles\nexpect A 0.0 = 1\n"
                "unforce\nwait 2 cycles\nexpect A 0.0 = 0\n")),
            "0 failures");
}

TEST(Runner, AForceActsAtOnce) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("wait 2 cycles\nforce E 0.0 = 1, A 4.0 = 1\nexpect E 0.0 = 1\n"
                                "expect A 4.0 = 1\nexpect PAB 4 = 1\n")),
            "0 failures");
}

TEST(Runner, ThePeripheryShowsItsOwnSide) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("set E 0.0 = 1\nexpect PEB 0 = 1\nexpect PAB 0 = 0\n"
                                "wait 3 cycles\nexpect PAB 0 = 1\n")),
            "0 failures");
}

TEST(Runner, WithoutPowerNothingStarts) {
  const Machine machine(kProgram);
  for (const char* step :
       {"run", "warm restart", "cold restart", "hot restart", "memory reset", "copy RAM to ROM",
        "unforce", "trigger OB 40", "set MW 0 = 5", "set E 0.0 = 1, Z 1 = 5", "force E 0.0 = 1"})
    EXPECT_EQ(failure(machine.run(std::string("power off\n") + step + "\n")),
              std::string("2: ") + step + ": the CPU is switched off; use 'power on' first");
}

// S7-STATE-09: what lies at a terminal needs no CPU; its memory does.
TEST(Runner, WithoutPowerTerminalsCanBeSet) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("power off\nset E 0.0 = 1, PEB 1 = 5\nwait 1s\npower on\n"
                                "wait 2 cycles\nexpect A 0.0 = 1\nexpect EB 1 = 5\n")),
            "0 failures");
}

TEST(Runner, WithoutPowerTheReasonIsThePower) {
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("power off\nexpect mode = RUN\n")),
            "2: expected mode = RUN, mode is STOP: the CPU is switched off");
  EXPECT_EQ(failure(machine.run("power off\nwait 3 cycles\n")),
            "2: wait 3 cycles: the CPU is in STOP: the CPU is switched off");
}

TEST(Runner, TheModel314HasNoHotRestart) {  // S7-STATE-05, S7-OPEN-43
  const Machine machine(kProgram);
  EXPECT_EQ(failure(machine.run("stop\nhot restart\n")),
            "2: hot restart: the CPU refuses: CPU 314C-2 PtP has no hot restart");
}

constexpr const char* kLongValues =
    "DATA_BLOCK DB 1\nSTRUCT\n t : DATE_AND_TIME := DT#1998-04-14-17:53:17.333;\n"
    " s : STRING [5] := 'ab';\n u : STRING [5] := 'abc';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nEND_ORGANIZATION_BLOCK\n";

TEST(Runner, DatesAndTextsInTheirOwnNotation) {
  const Machine machine(kLongValues);
  EXPECT_EQ(failure(machine.run("expect DB1.t = DT#1998-04-14-17:53:17.333\n"
                                "expect DB1.t < DT#2001-01-01-00:00:00\n"
                                "expect DB1.s = 'ab'\nexpect 'ab' == DB1.s\nexpect DB1.s < DB1.u\n"
                                "set DB1.s = 'it$'s', DB1.t = DT#2005-03-01-08:00:00\n"
                                "expect DB1.s = 'it$'s'\nexpect DB1.DBB 8 = 5\n"
                                "expect DB1.t >= DT#2005-03-01-08:00:00.000\n"
                                "set DB1.u = DB1.s\nexpect DB1.u = DB1.s\n")),
            "0 failures");
  EXPECT_EQ(failure(machine.run("expect DB1.s = 'x'\n")), "1: expected DB1.s = 'x', DB1.s is 'ab'");
  EXPECT_EQ(failure(machine.run("expect DB1.s = DB1.u\n")),
            "1: expected DB1.s = DB1.u, DB1.s is 'ab', DB1.u is 'abc'");
  EXPECT_EQ(failure(machine.run("expect DB1.t = DT#1998-04-14-17:53:17.332\n")),
            "1: expected DB1.t = DT#1998-04-14-17:53:17.332, DB1.t is DT#1998-04-14-17:53:17.333");
  EXPECT_EQ(failure(machine.run("force DB1.s = 'x'\n")), "1: DB1.s cannot be forced");
}

// S7-SIM-12: no bit is forced twice, and what is forced is not set; unforce and a memory reset free
// it.
TEST(Runner, ForcesDoNotOverlap) {
  const Machine machine(kProgram);
  const auto begins = [&](const char* text, const char* reason) {
    const std::string found = failure(machine.run(text));
    EXPECT_TRUE(found.starts_with(reason)) << text << found;
  };
  begins("force E 0.0 = 1\nforce EB 0 = B#16#0\n", "2: EB 0 overlaps E 0.0");
  begins("force EB 0 = B#16#0\nrepeat 2\n  force E 0.0 = 1\nend\n", "3: E 0.0 overlaps EB 0");
  begins("force A 0.1 = 1, A 0.1 = 0\n", "1: A 0.1 cannot be set: the list names it twice");
  begins("force A 0.0 = 1\nset AB 0 = B#16#0\n", "2: AB 0 is forced");
  begins("force E 0.0 = 1, E 0.1 = 1\nforce E 0.0 = 0\nset E 0.0 = 1\n", "0 failures");
  begins("force EB 0 = B#16#0, A 0.0 = 1\nunforce\nforce E 0.0 = 1\nset AB 0 = B#16#0\n",
         "0 failures");
  begins("force EB 0 = B#16#0\nmemory reset\nforce E 0.0 = 1\n", "0 failures");
}

TEST(Runner, CountersAreSetByTheirCount) {
  const Machine machine(kProgram);
  EXPECT_EQ(
      failure(machine.run(
          "set Z 1 = 125\nexpect Z 1 = C#125\nset Z 1 = C#7\nexpect Z 1 = 7\nexpect Z 1 = TRUE\n")),
      "0 failures");
  EXPECT_EQ(failure(machine.run("set Z 1 = 12\nexpect Z 1 = 12\nset Z 2 = Z 1\nexpect Z 2 = 12\n")),
            "0 failures");
  for (const char* value : {"1000", "1024", "W#16#FFFF", "-1"})
    EXPECT_EQ(failure(machine.run("set Z 1 = " + std::string(value) + "\n")),
              "1: Z 1 cannot be set: it takes 0 to 999");
  EXPECT_EQ(failure(machine.run("set T 1 = S5T#1S\n")),
            "1: T 1 cannot be set: only the program starts a timer");
}

TEST(Runner, AFaultFailsUnlessTheScenarioSpeaksOfIt) {
  const Machine machine(kProgram);
  const std::string fault = failure(machine.run("set E 0.7 = 1\nwait 1s\n"));
  EXPECT_TRUE(fault.starts_with("2: expected no fault, the CPU went to STOP: ")) << fault;
  EXPECT_EQ(failure(machine.run("set E 0.7 = 1\nexpect mode = STOP within 1s\n")), "0 failures");
  EXPECT_EQ(
      failure(machine.run("set E 0.7 = 1\nwait 1s\nexpect diagnostics contains \"16#2521\"\n")),
      "0 failures");
  EXPECT_EQ(failure(machine.run("set E 0.7 = 1\nexpect LED SF = on within 1s\n")), "0 failures");
  EXPECT_TRUE(failure(machine.run("set E 0.7 = 1\nexpect MW 2 = 0 for 1s\n"))
                  .starts_with("2: expected no fault, "));
  const std::string wait = failure(machine.run("set E 0.7 = 1\nwait 9 cycles\n"));
  EXPECT_TRUE(wait.starts_with("2: wait 9 cycles: the CPU is in STOP")) << wait;
}

TEST(Runner, AStopIsSeenWhenItHappens) {
  const Machine machine(kProgram);
  const TestResult result = machine.run("set E 0.7 = 1\nexpect mode = STOP within 10s\n");
  EXPECT_TRUE(result.passed());
  EXPECT_LT(result.end, Instant{10'000'000});
}

TEST(Runner, AFaultInTheStartupIsSomethingToExpect) {
  const Machine machine(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nAUF DB 7\nL DBW 0\nEND_ORGANIZATION_BLOCK\n");
  const TestResult result =
      machine.run("expect mode = STOP\nexpect diagnostics contains \"DB 7\"\n");
  EXPECT_EQ(failure(result), "0 failures");
  EXPECT_LT(result.end, Instant{10'000'000});
  EXPECT_TRUE(failure(machine.run("wait 1s\n")).starts_with("1: expected no fault, "));
}

// S7-STATE-08: STARTUP to STOP is a transition like any other.
TEST(Runner, AStopCommandInTheStartupIsSomethingToExpect) {
  const Machine machine(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nL 7\nT MW 0\nCALL SFC 46\n"
      "END_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(failure(machine.run("wait 1s\nexpect mode = STOP\nexpect MW 0 = 7\n"
                                "expect diagnostics contains \"16#457F\"\n")),
            "0 failures");
}

TEST(Runner, AStartupThatNeverEndsIsNothingToExpect) {
  const Machine machine(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nEND_ORGANIZATION_BLOCK\n"
      "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nm: CALL SFC 47 (WT := 30000)\nSPA m\n"
      "END_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(failure(machine.run("expect mode = STARTUP\n")), "1: the CPU does not reach RUN");
}

TEST(Runner, DiagnosticsShowTheNewestEntryWhereTheyMiss) {
  const Machine machine(kProgram);
  const std::string text = failure(machine.run("expect diagnostics contains \"no such words\"\n"));
  EXPECT_TRUE(text.starts_with(
      "1: expected diagnostics contains \"no such words\", the newest entry is 16#"))
      << text;
}

TEST(Runner, TwoRunsAreTheSame) {
  const Machine machine(kProgram);
  const char* scenario = "set E 0.0 = 1\nexpect A 0.1 = 1 within 10s\nexpect MW 20 = 0\n";
  EXPECT_EQ(failure(machine.run(scenario)), failure(machine.run(scenario)));
  EXPECT_EQ(machine.run(scenario).end, machine.run(scenario).end);
}

}  // namespace
}  // namespace merker::simulator
