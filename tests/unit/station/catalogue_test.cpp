// Every row of the catalogue in operation: each CPU model with each module it can carry, on both
// engines, with interrupts, faults and all changes of state.
#include <gtest/gtest.h>

#include <algorithm>

#include "catalogue/counting.h"
#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::uint64_t kCycles = 2;

io::Module place(const ModuleType& type, std::uint32_t rack, std::uint32_t slot) {
  io::Module module;
  module.type = &type;
  module.rack = rack;
  module.slot = slot;
  module.parameters = io::Parameters::of(type);
  module.position = {"merker.toml", 10 * rack + slot, 1};
  return module;
}

// All that a module can be told to tell this CPU; without OB 82 a diagnosis would stop it.
void tellAll(io::Module& module, const CpuModel& model) {
  const ModuleType& type = *module.type;
  io::Parameters& parameters = module.parameters;
  parameters.diagnosticInterrupt = type.diagnosticInterrupt && model.hasOrganizationBlock(82);
  if (type.digitalInputs > 0)
    parameters.risingEdges = parameters.fallingEdges = type.interruptChannels;
  for (std::uint32_t c = 0; c < type.analogInputs; ++c)
    if (const MeasuringRange* range = parameters.analogInputs[c].range;
        range != nullptr && (type.interruptChannels >> c & 1) != 0)
      parameters.analogInputs[c].upperLimit = range->high / 2;
}

const ModuleType& named(std::string_view name) { return *findModuleTypes(name).at(0); }

// Where a module stands, and what it needs beside it; none if this CPU has no rack for it.
std::vector<io::Module> rackWith(const ModuleType& type, const CpuModel& model) {
  if (type.kind == ModuleKind::PowerSupply) return {place(type, 0, 1)};
  if (type.kind != ModuleKind::Interface) return {place(type, 0, 4)};
  if (model.racks == 1) return {};
  const bool pair = type.name == "IM 365";
  const ModuleType& input = named("SM 321 DI16xDC24V");
  return {place(pair ? type : named("IM 360"), 0, 3), place(pair ? type : named("IM 361"), 1, 3),
          place(input, 1, 4)};
}

std::string program(const CpuModel& model) {
  std::string awl = ob(1, "L MW 10; + 1; T MW 10; L MW 10; T AW 0;");
  for (const int number : {40, 80, 82, 83, 84, 85, 86, 87, 100, 121, 122})
    if (model.hasOrganizationBlock(static_cast<unsigned>(number)))
      awl += ob(number, "L MW 20; + 1; T MW 20;");
  return awl;
}

// The same on both engines: whatever one does the other does.
class Pair {
 public:
  Pair(const CpuModel& model, const std::shared_ptr<const block::Program>& program,
       const io::Configuration& hardware)
      : plcs_{Station({.model = &model, .hardware = hardware, .program = program}),
              Station({.model = &model,
                       .hardware = hardware,
                       .program = program,
                       .engine = Engine::Compiled})} {}

  template <typename Action>
  void both(Action action) {
    for (Station& plc : plcs_) action(plc);
    EXPECT_EQ(plcs_[0].now(), plcs_[1].now());
    EXPECT_EQ(plcs_[0].instructions(), plcs_[1].instructions());
    EXPECT_EQ(plcs_[0].mode(), plcs_[1].mode());
  }
  void start() {
    both([](Station& plc) { EXPECT_TRUE(plc.warmRestart()); });
    cycles();
  }
  void cycles() {
    both([](Station& plc) { plc.advanceCycles(kCycles); });
    both([](Station& plc) { plc.advanceTo(plc.now() + Duration::milliseconds(5)); });
    for (const Station& plc : plcs_) EXPECT_EQ(plc.mode(), Mode::Run) << plc.stopReason();
  }
  void inputs(bool on) {
    both([on](Station& plc) {
      io::Rack& rack = *plc.rack();
      const auto& modules = rack.configuration().modules;
      for (std::uint32_t m = 0; m < modules.size(); ++m) {
        for (std::uint32_t c = 0; c < modules[m].type->digitalInputs; ++c)
          rack.setLevel({m, io::Side::DigitalInput, c}, on, plc.now());
        for (std::uint32_t c = 0; c < modules[m].type->analogInputs; ++c) {
          const io::Terminal terminal{m, io::Side::AnalogInput, c};
          const MeasuringRange* range = rack.range(terminal);
          if (range != nullptr)
            rack.setAmount(terminal, on ? 2 * range->high : range->low, plc.now());
        }
      }
    });
    cycles();
  }
  // Without its OB it stops the CPU, and a restart goes on.
  void fault(std::uint32_t module, io::FaultKind kind) {
    for (const bool there : {true, false}) {
      both([&](Station& plc) { plc.rack()->fault(module, kind, std::nullopt, there); });
      both([](Station& plc) { plc.advanceCycles(1); });
      both([](Station& plc) {
        EXPECT_EQ(plc.stopReason().find("without end"), std::string::npos) << plc.stopReason();
        if (plc.mode() == Mode::Stop) plc.warmRestart();
      });
    }
  }
  void states() {
    both([](Station& plc) { plc.stop(); });
    both([](Station& plc) { plc.advanceTo(plc.now() + Duration::milliseconds(20)); });
    start();
    both([](Station& plc) { plc.powerOff(); });
    both([](Station& plc) { plc.advanceTo(plc.now() + Duration::milliseconds(20)); });
    both([](Station& plc) { plc.powerOn(); });
    cycles();
    both([](Station& plc) { EXPECT_TRUE(plc.halt()); });
    both([](Station& plc) { plc.advanceTo(plc.now() + Duration::milliseconds(20)); });
    both([](Station& plc) { EXPECT_TRUE(plc.resume()); });
    both([](Station& plc) { plc.stop(); });
    both([](Station& plc) { plc.memoryReset(); });
    start();
  }

 private:
  Station plcs_[2];
};

constexpr io::FaultKind kFaults[] = {
    io::FaultKind::WireBreak, io::FaultKind::ShortCircuit,   io::FaultKind::Overflow,
    io::FaultKind::Underflow, io::FaultKind::LoadVoltage,    io::FaultKind::SensorSupply,
    io::FaultKind::Fuse,      io::FaultKind::Defect,         io::FaultKind::Removed,
    io::FaultKind::RackPower, io::FaultKind::ParameterError, io::FaultKind::InterruptLost};

// `all`: also faults of what the CPU brings itself.
void operate(const CpuModel& model, const std::shared_ptr<const block::Program>& program,
             const io::Configuration& hardware, bool all) {
  Pair pair(model, program, hardware);
  pair.start();
  pair.inputs(true);
  pair.inputs(false);
  for (std::uint32_t m = 0; m < hardware.modules.size(); ++m)
    for (const io::FaultKind kind : kFaults)
      if ((all || !hardware.modules[m].onBoard()) && io::possible(*hardware.modules[m].type, kind))
        pair.fault(m, kind);
  pair.cycles();
  pair.states();
}

TEST(Catalogue, EachCpuRunsWithEachModule) {
  for (const CpuModel& model : cpuModels()) {
    const auto code = compileAwl(program(model), model);
    unsigned carried = 0;
    for (const ModuleType& type : moduleTypes()) {
      SCOPED_TRACE(std::string(model.name) + ", " + title(type));
      auto modules = rackWith(type, model);
      if (modules.empty()) continue;
      for (io::Module& module : modules) tellAll(module, model);
      Problems problems;
      const io::Configuration hardware = io::configure(std::move(modules), model, problems);
      if (problems.hasErrors()) continue;
      operate(model, code, hardware, carried == 0);
      ++carried;
    }
    EXPECT_GE(carried, moduleTypes().size() / 2) << model.name;
  }
}

io::Module counting(const CpuModel& model, io::CountMode mode) {
  io::Module module = place(*onBoardType(model, 4), 0, 2);
  module.subslot = 4;
  module.parameters.hardwareInterrupt = true;
  for (std::uint32_t c = 0; c < model.onBoard.counters; ++c) {
    io::CountChannel& channel = module.parameters.counters[c];
    channel.mode = mode;
    channel.maxFrequency = countingType(model)->frequencies.front();
    channel.onGateOpened = channel.onGateClosed = channel.onComparator = channel.onOverflow =
        channel.onUnderflow = channel.onCountEdge = true;
    channel.hardwareGate = mode != io::CountMode::None;
  }
  return module;
}

TEST(Catalogue, EachCompactCpuRunsInEachModeOfItsChannels) {
  constexpr io::CountMode kModes[] = {io::CountMode::None,      io::CountMode::Endless,
                                      io::CountMode::Once,      io::CountMode::Periodic,
                                      io::CountMode::Frequency, io::CountMode::PulseWidth};
  for (const CpuModel& model : cpuModels()) {
    if (countingType(model) == nullptr) continue;
    const auto code = compileAwl(program(model), model);
    for (const io::CountMode mode : kModes) {
      SCOPED_TRACE(std::string(model.name) + ", mode " + std::to_string(static_cast<int>(mode)));
      Problems problems;
      operate(model, code, io::configure({counting(model, mode)}, model, problems), true);
      EXPECT_FALSE(problems.hasErrors());
    }
  }
}

}  // namespace
}  // namespace merker::station::test
