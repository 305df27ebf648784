// Asynchronous errors and interrupts of modules: OB 40, 80 to 87.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "cpu/trigger.h"
#include "program.h"

namespace merker::station::test {
namespace {

using Kind = ModuleEvent::Kind;

const CpuModel& generic() { return *findCpuModel("generic"); }

// Counts its calls in MW at, keeps its start information behind.
std::string counting(int number, int at) {
  const auto word = [&](int offset) { return std::to_string(at + offset); };
  return ob(number, "L MW " + word(0) + "; + 1; T MW " + word(0) + "; L LD 0; T MD " + word(2) +
                        "; L LD 4; T MD " + word(6) + "; L LD 8; T MD " + word(10) + ";");
}

void settle(Plc& plc) { plc->advanceCycles(2); }

struct Row {
  int ob;
  cpu::Trigger trigger;
  unsigned event, stop;
  unsigned first, second, third;  // bytes 0..3, 4..7, 8..11
};
const Row kRows[] = {
    {80, {.ob = 80}, 0x3501, 0x4568, 0x35011A50, 0, 0x11030101},
    {82,
     {.ob = 82, .address = 256, .data = 0x05000000},
     0x3942,
     0x456A,
     0x39421A52,
     0x00540100,
     0x05000000},
    {82, {.ob = 82, .going = true, .address = 256}, 0x3842, 0x456A, 0x38421A52, 0x00540100, 0},
    {83, {.ob = 83, .address = 4}, 0x3961, 0x456B, 0x39611A53, 0x00540004, 0},
    {83, {.ob = 83, .going = true, .address = 4}, 0x3861, 0x456B, 0x38611A53, 0x00540004, 0},
    {84, {.ob = 84}, 0x3981, 0x456C, 0x39811A54, 0, 0},
    {85, {.ob = 85}, 0x35A1, 0x456D, 0x35A11A55, 0, 0},
    {86, {.ob = 86, .address = 1023, .points = 2}, 0x39C1, 0x456F, 0x39C11A56, 0x000003FF, 2},
    {87, {.ob = 87}, 0x35E1, 0x456E, 0x35E11A57, 0, 0},
};

// S7-ERR-01, S7-BLK-14, S7-DIAG-02, S7-DIAG-03, S7-OBI-07, S7-OBI-09, S7-OBI-10, S7-OBI-11,
// S7-SIM-13: each one without its OB ends in STOP with its own event …
TEST(AsynchronousErrors, WithoutTheirObTheCpuStops) {
  for (const Row& row : kRows) {
    Plc plc(ob(1, ""), generic());
    plc.cycles(1);
    cpu::trigger(plc->cpu(), row.trigger);
    EXPECT_EQ(plc->mode(), Mode::Stop) << row.ob;
    EXPECT_EQ(plc.lastEvent(), row.stop) << row.ob;
    EXPECT_TRUE(plc.hasEvent(row.event)) << row.ob;
    EXPECT_TRUE(plc->stoppedByFault());
  }
}

// … and with it the CPU goes on, the OB knows why.
TEST(AsynchronousErrors, WithTheirObTheCpuGoesOn) {
  for (const Row& row : kRows) {
    Plc plc(counting(row.ob, 100) + ob(1, ""), generic());
    plc.cycles(1);
    cpu::trigger(plc->cpu(), row.trigger);
    settle(plc);
    EXPECT_EQ(plc->mode(), Mode::Run) << row.ob;
    EXPECT_EQ(plc.read("MW 100"), 1u) << row.ob;
    EXPECT_EQ(plc.read("MD 102"), row.first) << row.ob;
    EXPECT_EQ(plc.read("MD 106"), row.second) << row.ob;
    EXPECT_EQ(plc.read("MD 110"), row.third) << row.ob;
    EXPECT_TRUE(plc.hasEvent(row.event)) << row.ob;
  }
}

// S7-ERR-01, S7-OBI-08, S7-CPU-31: OB 81 is the exception.
TEST(AsynchronousErrors, Ob81IsNotNeeded) {
  Plc plc(ob(1, ""), generic());
  plc.cycles(1);
  plc->setBattery(true);
  settle(plc);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.lastEvent(), 0x3922u);
  EXPECT_EQ(plc->leds().batf, cpu::Light::On);
  EXPECT_EQ(plc->leds().sf, cpu::Light::On);
  plc->setBattery(false);
  EXPECT_EQ(plc.lastEvent(), 0x3822u);
  EXPECT_EQ(plc->leds().sf, cpu::Light::Off);

  Plc with(counting(81, 100) + ob(1, ""), generic());
  with.cycles(1);
  with->setBattery(true);
  settle(with);
  EXPECT_EQ(with.read("MD 102"), 0x39221A51u);
}

// S7-DIAG-03: each of 14 classes stands in its fourth OB 121 when the next one interrupts; the
// stack of interrupted blocks has 64 places.
TEST(Interrupts, NestedTooDeeplyStopTheCpu) {
  CpuParameters parameters = CpuParameters::of(generic());
  for (std::uint8_t i = 0; i < 9; ++i)
    parameters.cyclic.push_back(
        {.ob = static_cast<std::uint8_t>(30 + i), .interval = 1000, .phase = 10 * i});
  const std::string fails = "L 0; T MW 10; L MW 12; + 1; T MW 12; AUF DB 99;";
  std::string program =
      ob(121,
         "L MW 14; + 1; T MW 14; L MW 10; + 1; T MW 10; L 4; <I; SPBN M001; AUF DB 99; BEA;"
         "M001: CALL SFC 43; SPA M001;");
  for (int i = 0; i < 9; ++i) program += ob(30 + i, fails);
  std::string begin;
  for (int i = 0; i < 4; ++i) {
    program += ob(20 + i, fails);
    begin += "CALL SFC 32 (OB_NR := " + std::to_string(20 + i) + ", DTIME := T#" +
             std::to_string(10 + 10 * i) + "MS, SIGN := W#16#0, RET_VAL := MW 20);";
  }
  Plc plc(program + ob(1, begin + fails), generic(), parameters);
  plc.start();
  plc->advanceTo(plc->now() + Duration::seconds(3));
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_EQ(plc.lastEvent(), 0x4574u);
  EXPECT_EQ(plc.read("MW 12"), 13u);  // OB 1, 20 to 23, 30 to 37: the next finds no place
  EXPECT_EQ(plc.read("MW 14"), 51u);  // 64 less 13
}

// S7-ERR-05, S7-CPU-31: SF shines as long as the fault is there.
TEST(ModuleEvents, DiagnosisComesAndGoes) {
  Plc plc(counting(82, 100) + ob(1, ""));
  plc.cycles(1);
  plc->cpu().moduleEvents().happened(
      {.kind = Kind::DiagnosticComing, .address = 256, .data = {5, 1, 0, 0}});
  settle(plc);
  EXPECT_EQ(plc->leds().sf, cpu::Light::On);
  EXPECT_EQ(plc.read("MD 110"), 0x05010000u);
  plc->cpu().moduleEvents().happened({.kind = Kind::DiagnosticGoing, .address = 256});
  settle(plc);
  EXPECT_EQ(plc.read("MW 100"), 2u);
  EXPECT_EQ(plc.read("MD 102"), 0x38421A52u);
  EXPECT_EQ(plc->leds().sf, cpu::Light::Off);
}

// S7-BLK-14: class 28 in STARTUP, so that it interrupts OB 100; S7-STATE-11: OB 40 waits.
TEST(ModuleEvents, InStartup) {
  Plc plc(ob(100, "CALL SFC 47 (WT := 20000); L MW 100; T MW 20; L MW 120; T MW 22;") +
          counting(82, 100) + counting(40, 120) + ob(1, ""));
  plc.start();
  plc->advanceTo(plc->now() + Duration::milliseconds(5));
  plc->cpu().moduleEvents().happened({.kind = Kind::DiagnosticComing, .address = 256});
  plc->cpu().moduleEvents().happened(
      {.kind = Kind::HardwareInterrupt, .address = 124, .points = 1});
  plc->advanceCycles(1);
  EXPECT_EQ(plc.read("MW 20"), 1u);
  EXPECT_EQ(plc.read("MD 102"), 0x39421C52u);
  EXPECT_EQ(plc.read("MW 22"), 0u);
  EXPECT_EQ(plc.read("MW 120"), 1u);
}

// In STOP a fault is entered and no OB runs, hardware interrupts are nothing.
TEST(ModuleEvents, InStop) {
  Plc plc(counting(82, 100) + counting(40, 120) + ob(1, ""));
  plc.cycles(1);
  plc->stop();
  plc->cpu().moduleEvents().happened({.kind = Kind::DiagnosticComing, .address = 256});
  plc->cpu().moduleEvents().happened(
      {.kind = Kind::HardwareInterrupt, .address = 124, .points = 1});
  EXPECT_EQ(plc.lastEvent(), 0x3942u);
  plc.cycles(3);
  EXPECT_EQ(plc.read("MW 100"), 0u);
  EXPECT_EQ(plc.read("MW 120"), 0u);
}

// S7-BLK-11, S7-OBI-06: address and channel; priority 16 interrupts OB 35 (12).
TEST(HardwareInterrupt, CallsOb40) {
  Plc plc(counting(40, 100) +
          ob(35, "L 1; T MW 20; CALL SFC 47 (WT := 10000); L MW 100; T MW 22;") + ob(1, ""));
  plc.start();
  plc->advanceTo(plc->now() + Duration::milliseconds(105));
  EXPECT_EQ(plc.read("MW 20"), 1u);
  plc->cpu().moduleEvents().happened(
      {.kind = Kind::HardwareInterrupt, .address = 124, .points = 2});
  plc.run(Duration::milliseconds(10));
  EXPECT_EQ(plc.read("MW 22"), 1u);
  EXPECT_EQ(plc.read("MD 102"), 0x11411028u);
  EXPECT_EQ(plc.read("MD 106"), 0x0054007Cu);
  EXPECT_EQ(plc.read("MD 110"), 2u);
}

// S7-OBI-10: without OB 40 OB 85 with A1; without that STOP.
TEST(HardwareInterrupt, WithoutOb40) {
  const ModuleEvent edge{.kind = Kind::HardwareInterrupt, .address = 124, .points = 1};
  Plc plc(counting(85, 100) + ob(1, ""));
  plc.cycles(1);
  plc->cpu().moduleEvents().happened(edge);
  settle(plc);
  EXPECT_EQ(plc.read("MD 102"), 0x35A11A55u);
  EXPECT_EQ(plc.read("MD 110") >> 16, 0x1141u);
  Plc stops(ob(1, ""));
  stops.cycles(1);
  stops->cpu().moduleEvents().happened(edge);
  EXPECT_EQ(stops.lastEvent(), 0x456Du);
}

// S7-ERR-05: two edges of a channel during OB 40: one repeat; other channels are kept too.
TEST(HardwareInterrupt, OneEdgeOfAChannelIsStored) {
  const std::string slow =
      ob(40, "L MW 100; + 1; T MW 100; L LD 8; T MD 104; CALL SFC 47 (WT := 10000);");
  const ModuleEvent edge{.kind = Kind::HardwareInterrupt, .address = 124, .points = 1};
  const ModuleEvent other{.kind = Kind::HardwareInterrupt, .address = 124, .points = 4};
  Plc plc(slow + ob(1, ""));
  plc.cycles(1);
  plc->cpu().moduleEvents().happened(edge);
  plc->advanceTo(plc->now() + Duration::milliseconds(2));
  EXPECT_EQ(plc.read("MW 100"), 1u);
  plc->cpu().moduleEvents().happened(edge);
  plc->cpu().moduleEvents().happened(other);
  EXPECT_FALSE(plc.hasEvent(0x3502));
  plc->cpu().moduleEvents().happened(edge);
  EXPECT_TRUE(plc.hasEvent(0x3502));
  plc.run(Duration::milliseconds(50));
  EXPECT_EQ(plc->mode(), Mode::Run);  // no OB 80: the entry is all
  EXPECT_EQ(plc.read("MW 100"), 2u);
  EXPECT_EQ(plc.read("MD 104"), 5u);

  Plc handled(slow + counting(80, 110) + ob(1, ""));
  handled.cycles(1);
  for (int i = 0; i < 3; ++i) {
    handled->cpu().moduleEvents().happened(edge);
    handled->advanceTo(handled->now() + Duration::milliseconds(1));
  }
  handled.run(Duration::milliseconds(50));
  EXPECT_EQ(handled.read("MW 110"), 1u);
  EXPECT_EQ(handled.read("MD 112"), 0x35021A50u);
  EXPECT_EQ(handled.read("MD 120"), 0x11411028u);
}

// S7-OBI-07: FLT_ID 07, more requests of one class than the CPU stores.
TEST(Overload, CallsOb80) {
  Plc plc(counting(80, 110) + counting(82, 100) + ob(1, ""));
  plc.cycles(1);
  for (std::uint16_t i = 0; i < 40; ++i)
    plc->cpu().moduleEvents().happened({.kind = Kind::DiagnosticComing, .address = i});
  settle(plc);
  EXPECT_EQ(plc->mode(), Mode::Run);
  EXPECT_EQ(plc.read("MD 112"), 0x35071A50u);
  EXPECT_EQ(plc.read("MW 100"), 32u);
}

// S7-OBI-07: FLT_ID 05 and 06; the information says which OB.
TEST(TimeOfDay, JumpedOver) {
  CpuParameters parameters = CpuParameters::of(generic());
  parameters.timeOfDay = {{.ob = 11, .active = true, .period = 0x0201, .start = 0}};
  Plc plc(counting(80, 110) + counting(11, 100) + ob(1, ""), generic(), parameters);
  plc.cycles(1);
  plc->cpu().setClock(2 * 60'000 + 1'000);
  settle(plc);
  EXPECT_EQ(plc.read("MD 112"), 0x35051A50u);
  EXPECT_EQ(plc.read("MD 116"), 2u);
  EXPECT_EQ(plc.read("MW 100"), 0u);
  plc.run(Duration::seconds(60));
  EXPECT_EQ(plc.read("MW 100"), 1u);
  plc->halt();
  plc.run(Duration::seconds(70));
  plc->resume();
  settle(plc);
  EXPECT_EQ(plc.read("MD 112"), 0x35061A50u);
  EXPECT_EQ(plc.read("MW 100"), 1u);
}

// S7-DIAG-01: 20 bytes each: event, class and OB, information, time.
TEST(Diagnostics, EntriesAreStartInformation) {
  Plc plc(counting(82, 100) + ob(1, ""));
  plc.cycles(1);
  plc->cpu().moduleEvents().happened(
      {.kind = Kind::DiagnosticComing, .address = 256, .data = {5, 1, 2, 3}});
  const cpu::DiagnosticEvent& entry = plc->cpu().diagnostics().events().back();
  EXPECT_EQ(entry.event, 0x3942);
  EXPECT_EQ(entry.info, (std::array<std::uint8_t, 10>{26, 82, 0, 0x54, 1, 0, 5, 1, 2, 3}));
  EXPECT_EQ(entry.stamp, plc->cpu().log().dateAndTime());
}

// S7-OBI-11: the entry names the racks; each rack comes and goes for itself.
TEST(AsynchronousErrors, RacksByTheirNumber) {
  Plc plc(ob(86, "NOP 0;") + ob(1, ""), generic());
  plc.cycles(1);
  cpu::trigger(plc->cpu(), {.ob = 86, .points = 2});
  EXPECT_EQ(plc->diagnostics().back().text, "rack failed, coming: rack 1");
  cpu::trigger(plc->cpu(), {.ob = 86, .points = 8});
  cpu::trigger(plc->cpu(), {.ob = 86, .going = true, .points = 2});
  EXPECT_EQ(plc->diagnostics().back().text, "rack failed, going: rack 1");
  EXPECT_EQ(plc->leds().bf, cpu::Light::On);
  cpu::trigger(plc->cpu(), {.ob = 86, .going = true, .points = 8});
  EXPECT_EQ(plc->leds().bf, cpu::Light::Off);
}

}  // namespace
}  // namespace merker::station::test
