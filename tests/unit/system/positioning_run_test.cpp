// SFB 44 and SFB 46 in a program, with the axis at the terminals of the CPU: the golden runs of the
// requirements, to the pulse and the cycle of 4 ms.
#include <gtest/gtest.h>

#include "axis_plc.h"

namespace merker::station::test {
namespace {

void ramps(AxisPlc& plc, std::int32_t speed, std::int32_t acceleration) {
  plc.set("SPEED", speed);
  plc.set("ACCEL", acceleration);
  plc.set("DECEL", acceleration);
}

// The instant of the call that starts a run.
Instant start(AxisPlc& plc, std::int32_t mode, std::string_view bit, std::int32_t target = 0) {
  plc.set("MODE_IN", mode);
  plc.set("TARGET", target);
  plc.call();
  plc.set(bit, 1);
  plc.call();
  EXPECT_EQ(plc.read("STATUS"), 0u);
  EXPECT_EQ(plc.read("WORKING"), 1u);
  const Instant begin = plc.station.now();
  plc.set(bit, 0);
  return begin;
}

class BothEngines : public testing::TestWithParam<Engine> {};

// POS-RUN-30: golden run A1. POS-RUN-02, POS-OPEN-01: outputs change in cycles of 4 ms.
// POS-WIRE-06, POS-WIRE-09, POS-OVW-14, POS-PLANT-18
TEST_P(BothEngines, GoldenRunA1) {
  AxisPlc plc(analogChannel(), {}, {}, false, GetParam());
  ramps(plc, 10'000, 1000);
  const Instant begin = start(plc, 4, "DIR_P", 200'000);
  EXPECT_EQ(plc.untilSet(begin, "RAMP_UP", false), 2499);
  EXPECT_EQ(plc.untilSet(begin, "RAMP_DN"), 4988);  // POS-RUN-07
  EXPECT_EQ(plc.number("ACT_POS"), 149'520);
  EXPECT_TRUE(plc.output(6));
  EXPECT_EQ(plc.untilSet(begin, "CHGOVER"), 7234);
  EXPECT_EQ(plc.number("ACT_POS"), 199'003);
  EXPECT_EQ(plc.read("RAMP_DN"), 0u);
  EXPECT_EQ(plc.untilSet(begin, "CUTOFF"), 7459);
  EXPECT_EQ(plc.number("ACT_POS"), 199'903);
  EXPECT_EQ(plc.read("WORKING"), 0u);
  EXPECT_FALSE(plc.output(6));
  EXPECT_EQ(plc.volts(), 0);
  EXPECT_EQ(plc.untilSet(begin, "POS_RCD"), 7483);
  plc.wait(1000);
  EXPECT_EQ(plc.number("ACT_POS"), 200'003);
  EXPECT_EQ(plc.number("DIST_TO_GO"), -3);
  EXPECT_NEAR(plc.plantValue("POSITION"), 200'003.904, 1e-6);
  EXPECT_EQ(plc.read("ERR"), 0u);
}
INSTANTIATE_TEST_SUITE_P(Positioning, BothEngines,
                         testing::Values(Engine::Interpreter, Engine::Compiled));

// POS-RUN-14, POS-RUN-15: golden runs A2 and A3.
TEST(PositioningRun, GoldenRunsA2AndA3) {
  AxisPlc plc(analogChannel());
  ramps(plc, 10'000, 1000);
  Instant begin = start(plc, 4, "DIR_P", 20'000);
  EXPECT_EQ(plc.untilSet(begin, "RAMP_DN"), 1104);
  EXPECT_EQ(plc.untilSet(begin, "CHGOVER"), 1958);
  EXPECT_EQ(plc.untilSet(begin, "CUTOFF"), 2183);

  AxisPlc near(analogChannel());
  ramps(near, 10'000, 1000);
  begin = start(near, 4, "DIR_P", 800);
  EXPECT_EQ(near.read("CHGOVER"), 1u);
  EXPECT_EQ(near.untilSet(begin, "CUTOFF"), 300);
  EXPECT_EQ(near.number("ACT_POS"), 700);
}

// POS-RUN-31, POS-DIGCTRL-09, POS-OVW-15, POS-WIRE-08: golden run D1 with its outputs.
TEST(PositioningRun, GoldenRunD1) {
  AxisPlc plc(digitalChannel());
  plc.set("SPEED", 1);
  plc.set("CHGDIFF_P", 3000);
  const Instant begin = start(plc, 4, "DIR_P", 20'000);
  const auto outputs = [&] {
    return std::vector<bool>{plc.output(8), plc.output(9), plc.output(10), plc.output(11)};
  };
  plc.wait(8);
  EXPECT_EQ(outputs(), (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(plc.operand("PAB 125") & 0xF, 0b0101u);
  EXPECT_EQ(plc.untilSet(begin, "CHGOVER"), 488);
  EXPECT_EQ(plc.number("ACT_POS"), 17'020);
  EXPECT_EQ(outputs(), (std::vector<bool>{false, true, true, false}));
  EXPECT_EQ(plc.untilSet(begin, "CUTOFF"), 702);
  EXPECT_EQ(plc.read("WORKING"), 0u);
  EXPECT_EQ(outputs(), (std::vector<bool>{false, false, false, false}));
  EXPECT_EQ(plc.untilSet(begin, "POS_RCD"), 727);
  plc.wait(1000);
  EXPECT_EQ(plc.number("ACT_POS"), 20'001);
}

// POS-RUN-32, POS-RUN-42: golden run D2 overshoots by far, without an error.
TEST(PositioningRun, GoldenRunD2) {
  AxisPlc plc(digitalChannel());
  plc.set("SPEED", 1);
  const Instant begin = start(plc, 4, "DIR_P", 20'000);
  EXPECT_EQ(plc.untilSet(begin, "CHGOVER"), 538);
  EXPECT_EQ(plc.number("ACT_POS"), 19'020);
  EXPECT_EQ(plc.untilSet(begin, "CUTOFF"), 563);
  plc.wait(3000);
  EXPECT_EQ(plc.number("DIST_TO_GO"), -6320);
  EXPECT_EQ(plc.read("ERR"), 0u);
  EXPECT_EQ(plc.read("ERROR"), 0u);
  EXPECT_EQ(plc.read("POS_RCD"), 1u);
}

struct Reference {
  const char *start, *name;
  std::int32_t from;
  bool minusLocation;
  std::int64_t sync, end;
  std::int32_t position;
};

// POS-REF-02, POS-REF-05, POS-REF-06, POS-REF-07, POS-REF-14, POS-PLANT-14, POS-OPEN-22: golden
// runs R1 to R3.
TEST(PositioningRun, GoldenReferenceRuns) {
  const Reference kRuns[] = {{"DIR_P", "R1", 10'000, false, 2165, 2215, 600},
                             {"DIR_P", "R2", 10'000, true, 2115, 2165, 400},
                             {"DIR_M", "R3", 33'000, false, 775, 825, 600}};
  for (const Reference& run : kRuns) {
    AxisChannel p = analogChannel();
    p.reference = 500;
    p.referenceBelowSwitch = run.minusLocation;
    AxisPlc plc(p, {{"start", run.from}});
    ramps(plc, 5000, 5000);
    const Instant begin = start(plc, 3, run.start);
    EXPECT_EQ(plc.read("SYNC"), 0u) << run.name;
    EXPECT_EQ(plc.untilSet(begin, "SYNC"), run.sync) << run.name;
    EXPECT_EQ(plc.untilSet(begin, "WORKING", false), run.end) << run.name;
    plc.wait(500);
    EXPECT_EQ(plc.number("ACT_POS"), run.position) << run.name;
    EXPECT_EQ(plc.number("LAST_TRG"), run.position) << run.name;
    EXPECT_EQ(plc.read("POS_RCD"), 0u) << run.name;
  }
}

// POS-END-06, POS-END-07: what an abort does, in its order. POS-PARAM-07, POS-RUN-20
TEST(PositioningRun, DriveEnableEndsARun) {
  AxisPlc plc(analogChannel());
  ramps(plc, 10'000, 10'000);
  start(plc, 4, "DIR_P", 100'000);
  plc.wait(2000);
  EXPECT_NEAR(plc.volts(), 10, 1e-9);
  plc.set("DRV_EN", 0);
  plc.call();
  const Instant abort = plc.station.now();
  EXPECT_EQ(plc.read("WORKING"), 0u);
  EXPECT_EQ(plc.read("ST_ENBLD"), 0u);
  plc.wait(4);
  EXPECT_EQ(plc.volts(), 0);
  EXPECT_TRUE(plc.output(6));
  EXPECT_EQ(plc.cycleOf(abort, [&] { return !plc.output(6); }), 250);
  plc.set("DRV_EN", 1);
  plc.wait(2000);
  const std::int32_t target = plc.number("LAST_TRG");
  EXPECT_NEAR(target, 15'000, 200);
  EXPECT_GT(plc.number("ACT_POS"), target);  // it has coasted on
  EXPECT_EQ(plc.read("POS_RCD"), 0u);
}

// POS-END-08: the CPU goes to STOP; the enable falls when the cut-off delay has passed.
TEST(PositioningRun, StopOfTheCpuEndsARun) {
  AxisPlc plc(analogChannel());
  ramps(plc, 10'000, 10'000);
  start(plc, 4, "DIR_P", 100'000);
  plc.wait(2000);
  plc.station.stop();
  EXPECT_EQ(plc.volts(), 0);
  EXPECT_TRUE(plc.output(6));
  plc.wait(990);
  EXPECT_TRUE(plc.output(6));
  plc.wait(20);
  EXPECT_FALSE(plc.output(6));

  AxisPlc digital(digitalChannel());
  digital.set("SPEED", 1);
  start(digital, 4, "DIR_P", 20'000);
  digital.wait(100);
  EXPECT_TRUE(digital.output(8));
  digital.station.stop();
  EXPECT_FALSE(digital.output(8));
  EXPECT_FALSE(digital.output(10));
}

// POS-RUN-33, POS-PARAM-20, POS-ENC-11, POS-REF-01: STOP to RUN.
TEST(PositioningRun, RestartBeginsAnew) {
  AxisChannel p = analogChannel();
  p.reference = 500;
  AxisPlc plc(p);
  ramps(plc, 10'000, 10'000);
  EXPECT_EQ(plc.job(1, 3000), 0u);
  EXPECT_EQ(plc.read("SYNC"), 1u);
  start(plc, 4, "DIR_P", 10'000);
  plc.wait(500);
  plc.station.stop();
  plc.wait(3000);
  plc.set("DIR_P", 0);
  EXPECT_TRUE(plc.station.warmRestart());
  plc.station.advanceCycles(2);
  EXPECT_EQ(plc.read("SYNC"), 0u);
  EXPECT_EQ(plc.number("ACT_POS"), 500);
  EXPECT_EQ(plc.number("LAST_TRG"), 500);
  for (const char* bit : {"WORKING", "POS_RCD", "CUTOFF", "CHGOVER", "MSR_DONE", "ERR"})
    EXPECT_EQ(plc.read(bit), 0u) << bit;
  EXPECT_EQ(plc.number("DIST_TO_GO"), 0);
}

// HALT is no place to drive in (docs/compatibility.md).
TEST(PositioningRun, HaltEndsARun) {
  AxisPlc plc(analogChannel());
  ramps(plc, 10'000, 10'000);
  start(plc, 4, "DIR_P", 100'000);
  plc.wait(500);
  ASSERT_TRUE(plc.station.halt());
  EXPECT_EQ(plc.volts(), 0);
  ASSERT_TRUE(plc.station.resume());
  plc.station.advanceCycles(2);
  EXPECT_EQ(plc.read("WORKING"), 0u);
}

// POS-PARAM-09, POS-ENC-02: a pulse of 20 us at the input of the length measurement.
TEST(PositioningRun, FilterOfTheSwitches) {
  for (const std::uint32_t kilohertz : {10u, 60u}) {
    AxisChannel p = analogChannel();
    p.accompanyingFrequency = kilohertz;
    p.lengthEdges = io::LengthEdges::RisingFalling;
    AxisPlc plc(p);
    io::Rack& rack = *plc.station.rack();
    const io::Terminal input = *rack.terminal("2.2", io::Side::DigitalInput, 3);
    rack.setLevel(input, true, plc.station.now());
    plc.station.advanceTo(plc.station.now() + Duration::microseconds(20));
    rack.setLevel(input, false, plc.station.now());
    plc.wait(20);
    EXPECT_EQ(plc.read("MSR_DONE"), kilohertz == 60 ? 1u : 0u) << kilohertz;
  }
}

// POS-ERR-53: a data block that is too short, or write-protected, stays as it is; BIE says so.
TEST(PositioningRun, UselessDataBlocks) {
  const std::string more =
      "DATA_BLOCK DB 10 STRUCT a : ARRAY [1..80] OF BYTE; END_STRUCT BEGIN END_DATA_BLOCK\n"
      "DATA_BLOCK DB 11 READ_ONLY SFB 44 BEGIN DRV_EN := TRUE; END_DATA_BLOCK\n"
      "FUNCTION FC 1 : VOID\nBEGIN\nAUF DI 10; UC SFB 44; U BIE; = M 102.0; AUF DI 11; UC SFB 44; "
      "U BIE; = M 102.1; END_FUNCTION\n" +
      ob(35, "SET; = M 102.0; = M 102.1; UC FC 1;");
  AxisPlc plc(analogChannel(), {}, more);
  plc.wait(300);
  ASSERT_EQ(plc.station.mode(), Mode::Run);
  EXPECT_EQ(plc.operand("M 102.0"), 0u);
  EXPECT_EQ(plc.operand("M 102.1"), 0u);
  EXPECT_EQ(plc.operand("DB11.DBX 54.0"), 0u);
  EXPECT_EQ(plc.operand("M 101.0"), 1u);
}

// POS-DIAG-04
TEST(PositioningRun, WithoutOb82TheCpuStops) {
  AxisChannel p = analogChannel();
  p.interrupts.movement = true;
  AxisPlc plc(p, {}, {}, true);
  ramps(plc, 5000, 5000);
  plc.plantSet("BLOCKED", 1);
  plc.run(1, "DIR_P");
  plc.set("DIR_P", 1);
  plc.wait(3000);
  EXPECT_EQ(plc.station.mode(), Mode::Stop);
  EXPECT_NE(plc.station.stopReason().find("diagnostic"), std::string::npos)
      << plc.station.stopReason();
}

// POS-PARAM-01, POS-PARAM-27, POS-DIAG-02: without the interrupt selection there is no interrupt.
TEST(PositioningRun, WithoutTheSelectionNoInterrupt) {
  AxisChannel p = analogChannel();
  p.interrupts.movement = true;
  AxisPlc plc(p);
  ramps(plc, 5000, 5000);
  plc.plantSet("BLOCKED", 1);
  plc.set("MODE_IN", 1);
  plc.set("DIR_P", 1);
  plc.wait(3000);
  EXPECT_EQ(plc.read("ERR"), 0x2000u);
  EXPECT_EQ(plc.station.mode(), Mode::Run);
  EXPECT_FALSE(plc.station.rack()->faulty(*plc.station.rack()->module("2.5")));
}

// POS-WIRE-05, POS-WIRE-07, POS-RUN-17, POS-RUN-18: minus with a direction signal.
TEST(PositioningRun, DirectionSignal) {
  AxisChannel p = analogChannel();
  p.analogControl = io::AnalogControl::WithDirection;
  AxisPlc plc(p);
  ramps(plc, 5000, 20'000);
  start(plc, 4, "DIR_M", 10'000);
  plc.wait(1000);
  EXPECT_NEAR(plc.volts(), 5, 1e-9);
  EXPECT_TRUE(plc.output(7));
  plc.wait(5000);
  EXPECT_FALSE(plc.output(7));
  EXPECT_EQ(plc.number("LAST_TRG"), -10'000);
  EXPECT_NEAR(plc.number("ACT_POS"), -10'000, 25);
}

// POS-WIRE-03, POS-WIRE-08: all other outputs are the program's.
TEST(PositioningRun, OutputsOfTheProgram) {
  AxisPlc analog(analogChannel(), {}, ob(35, "L W#16#FFFF; T PAW 124;"));
  analog.wait(200);
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_EQ(analog.output(i), i != 6) << i;
  AxisPlc digital(digitalChannel(), {}, ob(35, "L W#16#FFFF; T PAW 124;"));
  digital.wait(200);
  for (std::uint32_t i = 0; i < 16; ++i) EXPECT_EQ(digital.output(i), i < 8 || i > 11) << i;
}

// The same trace on every run and with both engines (POS-PLANT-12).
TEST(PositioningRun, SameOnEveryRunAndEngine) {
  std::vector<std::vector<std::int32_t>> traces;
  for (const Engine engine : {Engine::Interpreter, Engine::Compiled, Engine::Interpreter}) {
    AxisPlc plc(analogChannel(), {{"stiction", 0.5}, {"time_constant", 0.02}, {"load", 2}}, {},
                false, engine);
    ramps(plc, 9000, 3000);
    start(plc, 4, "DIR_P", 20'000);
    std::vector<std::int32_t>& trace = traces.emplace_back();
    for (int i = 0; i < 500; ++i) {
      plc.wait(20);
      trace.push_back(plc.number("ACT_POS"));
    }
  }
  EXPECT_EQ(traces[0], traces[2]);
  EXPECT_EQ(traces[0].back(), traces[1].back());
}

}  // namespace
}  // namespace merker::station::test
