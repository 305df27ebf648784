// The seam to the modules: when the CPU looks at them, and what it tells them.
#include <gtest/gtest.h>

#include "cpu/cpu.h"
#include "program.h"

namespace merker::station::test {
namespace {

// A module that shows a growing number in EB 0 each 10 ms and notes what it is told.
struct Counter : cpu::Periphery {
  Instant due{Instant{} + Duration::milliseconds(10)};
  std::vector<std::uint8_t> outputs;
  std::vector<bool> disabled;
  std::uint32_t lastFirst = 0, lastCount = 0;

  Instant next() const override { return due; }
  void advance(cpu::Cpu& cpu, Instant now) override {
    EXPECT_GE(now, due);
    late = std::max(late, now - due);
    due = due + Duration::milliseconds(10);
    ++cpu.machine().areas.inputs[0];
  }
  void written(cpu::Cpu& cpu, std::uint32_t first, std::uint32_t count) override {
    lastFirst = first;
    lastCount = count;
    outputs.push_back(cpu.machine().areas.outputs[4]);
  }
  void disableOutputs(cpu::Cpu&, bool on) override { disabled.push_back(on); }
  Duration late{};
};

// In every operating state, at the first instruction boundary.
TEST(Periphery, ActsInVirtualTime) {
  Plc plc(ob(1, "M001: L PEB 0; L 3; <I; SPB M001; CALL SFC 64 (RET_VAL := MD 20);"));
  Counter module;
  plc->cpu().modules().connect(&module);
  plc.cycles(1);
  EXPECT_EQ(plc.read("MD 20"), 30u);
  EXPECT_LT(module.late, Duration::microseconds(50));
  plc->stop();
  plc.run(Duration::milliseconds(100));
  EXPECT_GE(plc->cpu().machine().areas.inputs[0], 12);
  plc->cpu().modules().connect(nullptr);
}

// S7-OPND-11: with a configuration only bytes of its modules answer, from the first byte on.
TEST(Periphery, BytesWithoutModuleDoNotAnswer) {
  io::Module module;
  module.type = findModuleTypes("SM 321 DI16xDC24V").at(0);
  module.slot = 5;
  module.parameters = io::Parameters::of(*module.type);
  Problems problems;
  Plc plc(ob(122, "L LW 6; T MW 10;") + ob(1, "L PEB 0; L PEB 4; L PEB 5;"), defaultCpuModel(),
          io::configure({module}, defaultCpuModel(), problems));
  EXPECT_FALSE(plc->read(plc.reference("PEB 0")));
  EXPECT_FALSE(plc->read(plc.reference("PEB 1")));
  EXPECT_TRUE(plc->read(plc.reference("PEB 4")));
  EXPECT_TRUE(plc->read(plc.reference("PEB 5")));
  plc.write("MW 10", 77);
  plc.cycles(1);
  EXPECT_EQ(plc.countEvents(0x2942), 1u);
  EXPECT_EQ(plc.read("MW 10"), 0u);
}

// A module that wants the same instant for ever must not hold the time: the CPU stops and says who,
// and the next start asks it again.
TEST(Periphery, ThatNeverEndsStopsTheCpu) {
  struct Endless : cpu::Periphery {
    bool hangs = false;
    unsigned calls = 0;
    Instant next() const override { return hangs ? Instant{} : Instant::never(); }
    void advance(cpu::Cpu&, Instant) override { ++calls; }
    void written(cpu::Cpu&, std::uint32_t, std::uint32_t) override {}
    void disableOutputs(cpu::Cpu&, bool) override {}
  } module;
  Plc plc(ob(1, "L MW 10; + 1; T MW 10;"));
  plc->cpu().modules().connect(&module);
  plc.cycles(3);
  module.hangs = true;
  plc.run(Duration::seconds(1));
  EXPECT_EQ(plc->mode(), Mode::Stop);
  EXPECT_TRUE(plc->stoppedByFault());
  EXPECT_EQ(plc.countEvents(0x456C), 1u);
  EXPECT_NE(plc->stopReason().find("modules: events at one instant without end"), std::string::npos)
      << plc->stopReason();
  const unsigned calls = module.calls;
  plc.run(Duration::seconds(1));  // in STOP it is not asked any more
  EXPECT_EQ(module.calls, calls);
  module.hangs = false;
  plc.cycles(3);
  EXPECT_EQ(plc->mode(), Mode::Run);
  plc->stop();
  module.hangs = true;
  plc->advanceTo(plc->now() + Duration::seconds(1));
  EXPECT_EQ(plc.countEvents(0x456C), 2u);
  plc->cpu().modules().connect(nullptr);
}

// S7-STATE-02, S7-STATE-11, S7-STATE-07: output disable in STOP, STARTUP and HALT.
TEST(Periphery, IsToldOfOutputs) {
  Plc plc(ob(1, "L 7; T AB 4; L 9; T PAB 4;"));
  Counter module;
  plc->cpu().modules().connect(&module);
  EXPECT_EQ(module.disabled, std::vector<bool>{true});
  plc.cycles(1);
  EXPECT_EQ(module.disabled, (std::vector<bool>{true, false}));
  EXPECT_EQ(module.outputs.back(), 9);
  EXPECT_EQ(module.lastFirst, 4u);
  EXPECT_EQ(module.lastCount, 1u);
  plc->halt();
  plc->resume();
  plc->stop();
  EXPECT_EQ(module.disabled, (std::vector<bool>{true, false, true, false, true}));
  plc->cpu().modules().connect(nullptr);
}

}  // namespace
}  // namespace merker::station::test
