// Operating states, mode switch, LEDs.
#include <gtest/gtest.h>

#include <algorithm>

#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

using cpu::Light;
using cpu::SwitchPosition;

const CpuModel& generic() { return *findCpuModel("generic"); }

// S7-STATE-08: every change of state that there is, and no other.
TEST(States, TableOfTransitions) {
  using cpu::isTransition;
  using M = cpu::Mode;
  const M all[] = {M::Stop, M::Startup, M::Run, M::Halt};
  const std::pair<M, M> ways[] = {
      {M::Stop, M::Startup}, {M::Startup, M::Run},  {M::Run, M::Stop},
      {M::Startup, M::Stop}, {M::Run, M::Halt},     {M::Startup, M::Halt},
      {M::Halt, M::Run},     {M::Halt, M::Startup}, {M::Halt, M::Stop}};
  for (const M from : all)
    for (const M to : all) {
      const bool listed =
          std::find(std::begin(ways), std::end(ways), std::pair(from, to)) != std::end(ways);
      EXPECT_EQ(isTransition(from, to), listed) << int(from) << " " << int(to);
    }
}

// S7-CPU-31, S7-SIM-11, S7-SIM-09: the switch starts and stops; RUN to RUN-P does neither.
TEST(Switch, StartsAndStops) {
  Plc plc(ob(1, "L MW 10; + 1; T MW 10;"));
  plc->setSwitch(SwitchPosition::Stop);
  EXPECT_EQ(plc->mode(), Mode::Stop);
  plc->setSwitch(SwitchPosition::Run);
  EXPECT_EQ(plc->mode(), Mode::Startup);
  plc.cycles(3);
  EXPECT_EQ(plc->mode(), Mode::Run);
  plc->setSwitch(SwitchPosition::RunP);
  plc.cycles(1);
  EXPECT_EQ(plc.read("MW 10"), 4u);
  plc->setSwitch(SwitchPosition::Stop);
  EXPECT_EQ(plc.lastEvent(), 0x4303u);
  EXPECT_EQ(plc->leds().stop, Light::On);
  EXPECT_EQ(plc->leds().run, Light::Off);
}

// S7-CPU-31, S7-STATE-10, S7-DIAG-02: three seconds at MRES, let go, back within three seconds.
TEST(Switch, MemoryResetByHand) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc.write("MB 0", 0x55);
  plc->setSwitch(SwitchPosition::Stop);
  plc->setSwitch(SwitchPosition::Mres);
  EXPECT_EQ(plc->leds().stop, Light::Slow);
  plc.run(Duration::milliseconds(2'900));
  plc->setSwitch(SwitchPosition::Stop);  // too early
  plc->setSwitch(SwitchPosition::Mres);
  EXPECT_EQ(plc.read("MB 0"), 0x55u);
  plc.run(Duration::seconds(3));
  EXPECT_EQ(plc->leds().stop, Light::On);
  plc->setSwitch(SwitchPosition::Stop);
  plc.run(Duration::milliseconds(3'100));  // too late
  plc->setSwitch(SwitchPosition::Mres);
  EXPECT_EQ(plc.read("MB 0"), 0x55u);
  plc.run(Duration::seconds(3));
  plc->setSwitch(SwitchPosition::Stop);
  plc.run(Duration::seconds(2));
  plc->setSwitch(SwitchPosition::Mres);
  EXPECT_EQ(plc.read("MB 0"), 0u);
  EXPECT_EQ(plc->leds().stop, Light::Fast);
  EXPECT_TRUE(plc.hasEvent(0x4308));
  EXPECT_EQ(plc.lastEvent(), 0x430Eu);
  plc->setSwitch(SwitchPosition::Stop);
  plc.run(Duration::seconds(4));
  EXPECT_EQ(plc->leds().stop, Light::On);
}

// S7-CPU-31
TEST(Leds, ShowTheState) {
  Plc plc(ob(100, "CALL SFC 47 (WT := 30000);") +
          ob(1, "U E 0.7; SPBN M001; AUF DB 99; M001: NOP 0;"));
  EXPECT_EQ(plc->leds().dc5v, Light::On);
  plc.start();
  EXPECT_EQ(plc->leds().run, Light::Fast);
  EXPECT_EQ(plc->leds().stop, Light::On);
  plc.cycles(2);
  EXPECT_EQ(plc->leds(), (cpu::Leds{.dc5v = Light::On, .run = Light::On}));
  EXPECT_TRUE(plc.force("E 1.0", 1));
  EXPECT_EQ(plc->leds().frce, Light::On);
  plc->unforce();
  EXPECT_EQ(plc->leds().frce, Light::Off);
  EXPECT_TRUE(plc->halt());
  EXPECT_EQ(plc->leds().run, Light::Slow);
  EXPECT_TRUE(plc->resume());
  plc.write("E 0.7", 1);
  plc->advanceCycles(2);
  EXPECT_EQ(plc->leds().sf, Light::On);
  EXPECT_EQ(plc->leds().stop, Light::On);
  plc->powerOff();
  EXPECT_EQ(plc->leds(), cpu::Leds{});
}

TEST(Leds, Blink) {
  EXPECT_FALSE(shines(Light::Slow, Instant{} + Duration::milliseconds(999)));
  EXPECT_TRUE(shines(Light::Slow, Instant{} + Duration::milliseconds(1'000)));
  EXPECT_FALSE(shines(Light::Fast, Instant{} + Duration::milliseconds(249)));
  EXPECT_TRUE(shines(Light::Fast, Instant{} + Duration::milliseconds(250)));
  EXPECT_FALSE(shines(Light::Fast, Instant{} + Duration::milliseconds(500)));
}

// S7-STATE-07, S7-TMR-22: nothing runs, timers stand still, outputs are off, the clock goes on.
TEST(Halt, FreezesTheProgram) {
  Plc plc(ob(1,
             "SET; = A 4.0; U E 0.0; L S5T#10S; SE T 1; LC T 1; T MW 0; U T 1; = M 9.0;"
             "CALL SFC 64 (RET_VAL := MD 20);") +
          ob(35, "L MW 30; + 1; T MW 30;"));
  plc.write("E 0.0", 1);
  plc.start();
  plc.run(Duration::milliseconds(4'000));
  EXPECT_EQ(plc.read("PAB 4"), 1u);
  const auto calls = plc.read("MW 30");
  EXPECT_TRUE(plc->halt());
  EXPECT_FALSE(plc->halt());
  EXPECT_EQ(plc->mode(), Mode::Halt);
  EXPECT_EQ(plc.lastEvent(), 0x4305u);
  EXPECT_EQ(plc.read("PAB 4"), 0u);
  const auto cycles = plc->cycles();
  plc.run(Duration::seconds(60));
  EXPECT_EQ(plc->cycles(), cycles);
  EXPECT_EQ(plc.read("MW 30"), calls);
  EXPECT_TRUE(plc->resume());
  EXPECT_EQ(plc.lastEvent(), 0x4306u);
  plc.run(Duration::milliseconds(5'900));
  EXPECT_EQ(plc->mode(), Mode::Run);  // also the cycle monitoring stood still
  EXPECT_EQ(plc.read("M 9.0"), 0u);
  plc.run(Duration::milliseconds(200));
  EXPECT_EQ(plc.read("M 9.0"), 1u);
  EXPECT_EQ(plc.read("PAB 4"), 1u);
  EXPECT_NEAR(plc.read("MW 30"), calls + 61, 1);
}

// S7-STATE-08, S7-DIAG-02
TEST(Halt, CanEndInStop) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc->halt();
  plc->stop();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc.hasEvent(0x430A));
  EXPECT_FALSE(plc->resume());
}

TEST(Halt, EndsInStopWithoutPower) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc->halt();
  plc->powerOff();
  plc->powerOn();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc.hasEvent(0x430A));
  EXPECT_NE(plc->stopReason().find("16#430A"), std::string::npos);
}

TEST(Halt, SingleSteps) {
  Plc plc(ob(1, "L 1; T MW 0; L 2; T MW 0;"));
  plc.cycles(1);
  EXPECT_TRUE(plc->halt());
  cpu::Cpu& cpu = plc->cpu();
  cpu.singleStep();  // between cycles: the cycle begins, L 1
  plc.run(Duration::seconds(1));
  cpu.singleStep();
  EXPECT_EQ(plc.read("MW 0"), 1u);
  cpu.singleStep();
  cpu.singleStep();
  EXPECT_EQ(plc.read("MW 0"), 2u);
  EXPECT_EQ(plc->mode(), Mode::Halt);
}

// S7-STATE-05, S7-OBI-12, S7-OBI-02: OB 101, then on where the program was interrupted.
TEST(HotRestart, GoesOnWhereItWas) {
  const std::string program =
      ob(100, "L MW 40; + 1; T MW 40;") + ob(101, "L LB 1; T MB 50; L LW 6; T MW 52;") +
      ob(1,
         "L LB 1; T MB 60; L MW 0; + 1; T MW 0; CALL SFC 47 (WT := 20000); L MW 2; + 1; T MW 2;"
         "L S5T#10S; U M 99.0; SE T 1;");
  Plc plc(program, generic());
  plc.start();
  plc.run(Duration::milliseconds(0));
  plc->advanceTo(plc->now() + Duration::milliseconds(10));  // inside OB 1
  plc.write("MB 200", 7);
  EXPECT_EQ(plc.read("MW 0"), 1u);
  EXPECT_EQ(plc.read("MW 2"), 0u);
  plc->stop();
  plc.run(Duration::seconds(5));
  EXPECT_TRUE(plc->hotRestart());
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MB 50"), 0x83u);
  EXPECT_EQ(plc.read("MW 52"), 0x4303u);
  EXPECT_EQ(plc.read("MW 0"), 1u);  // not from the beginning
  EXPECT_EQ(plc.read("MW 2"), 1u);
  EXPECT_EQ(plc.read("MB 200"), 7u);  // not retentive, and kept
  EXPECT_EQ(plc.read("MW 40"), 1u);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MB 60"), 2u);  // OB1_SCAN_1
  EXPECT_TRUE(plc.hasEvent(0x1383));
}

// S7-OPEN-43: not on a 314C; not after memory reset or a fault.
TEST(HotRestart, IsRefused) {
  Plc small(ob(1, ""));
  small.cycles(1);
  small->stop();
  EXPECT_FALSE(small->hotRestart());
  Plc plc(ob(1, "U E 0.0; SPBN M001; AUF DB 9; M001: NOP 0;"), generic());
  plc.cycles(1);
  plc->stop();
  plc->memoryReset();
  EXPECT_FALSE(plc->hotRestart());
  plc.cycles(1);
  plc.write("E 0.0", 1);
  plc->advanceCycles(2);
  EXPECT_TRUE(plc->stoppedByFault());
  EXPECT_FALSE(plc->hotRestart());
}

// S7-STATE-05, S7-STATE-04: what comes after power returns.
TEST(PowerOn, HotColdWarm) {
  const std::string program = ob(100, "L LB 1; T MB 0;") + ob(101, "L LB 1; T MB 1;") +
                              ob(102, "L LB 1; T MB 2;") + ob(1, "");
  const struct {
    PowerOnStart start;
    unsigned event;
    std::string_view flag;
    unsigned kind;
  } rows[] = {{PowerOnStart::Warm, 0x1382, "MB 0", 0x82},
              {PowerOnStart::Hot, 0x1384, "MB 1", 0x84},
              {PowerOnStart::Cold, 0x1386, "MB 2", 0x86}};
  for (const auto& row : rows) {
    CpuParameters parameters = CpuParameters::of(generic());
    parameters.afterPowerOn = row.start;
    Plc plc(program, generic(), parameters);
    plc.cycles(3);
    plc->powerOff();
    plc.run(Duration::seconds(1));
    plc->powerOn();
    plc->advanceCycles(1);
    EXPECT_EQ(plc->mode(), Mode::Run);
    EXPECT_TRUE(plc.hasEvent(row.event)) << row.event;
    EXPECT_EQ(plc.read(row.flag), row.kind);
  }
}

// S7-DIAG-02: 4309; retentive data are gone, the program comes from load memory.
TEST(PowerOn, WithoutBuffer) {
  Plc plc(ob(100, "L LB 9; T MB 60;") + ob(1, ""));
  plc.cycles(1);
  plc.write("MB 0", 0x55);
  plc->powerOff();
  plc->powerOn(false);
  plc->advanceCycles(1);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MB 0"), 0u);
  EXPECT_EQ(plc.read("MB 60"), 0x20u);  // STRT_INFO: automatically, not buffered
  EXPECT_TRUE(plc.hasEvent(0x4309));
  EXPECT_FALSE(plc.hasEvent(0x4300));
}

TEST(PowerOn, SwitchAtStopStaysInStop) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc->powerOff();
  plc->setSwitch(SwitchPosition::Stop);
  plc->powerOn();
  EXPECT_EQ(plc->mode(), Mode::Stop);
}

// S7-CPU-03: STOP blinks slowly until memory reset; no start before.
TEST(MemoryReset, CanBeRequested) {
  Plc plc(ob(1, ""));
  plc.cycles(1);
  plc->cpu().requestMemoryReset();
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc->leds().stop, Light::Slow);
  EXPECT_FALSE(plc->warmRestart());
  plc->memoryReset();
  EXPECT_EQ(plc->leds().stop, Light::On);
  EXPECT_TRUE(plc->warmRestart());
}

// S7-STATE-02, S7-STATE-11: outputs come with RUN, not before.
TEST(Outputs, AreDisabledInStartup) {
  Plc plc(ob(100, "L 1; T PAB 0; CALL SFC 47 (WT := 20000);") + ob(1, ""));
  plc.start();
  plc->advanceTo(plc->now() + Duration::milliseconds(5));
  EXPECT_EQ(plc->mode(), Mode::Startup);
  EXPECT_EQ(plc.read("PAB 0"), 0u);
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("PAB 0"), 1u);
}

}  // namespace
}  // namespace merker::station::test
