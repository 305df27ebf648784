// A CPU 314C-2 with its axis: the sub-module 2.5 and a plant at the terminals, DB 9 as the instance
// of a call of SFB 44 or SFB 46 in OB 1, which M 100.0 = 1 skips.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "program.h"
#include "step7/compiler.h"

namespace merker::station::test {

using io::AxisChannel;
using io::AxisOutput;

using PlantParameters = std::map<std::string, double>;

inline AxisChannel analogChannel() {
  AxisChannel p;
  p.highestSpeed = 10'000;
  p.creepSpeed = 1000;
  p.increments = 500;
  return p;
}

inline AxisChannel digitalChannel(std::uint8_t controlType = 1) {
  AxisChannel p;
  p.output = AxisOutput::Digital;
  p.digitalControl = controlType;
  p.increments = 500;
  return p;
}

class AxisPlc {
 public:
  explicit AxisPlc(const AxisChannel& axis, const PlantParameters& plant = {},
                   std::string_view more = {}, bool diagnostics = false,
                   Engine engine = Engine::Interpreter)
      : program_(compileAwl(text(axis.output, more), defaultCpuModel())),
        station(optionsOf(axis, plant, diagnostics, engine)) {
    station.warmRestart();
    station.advanceCycles(2);
    set("DRV_EN", 1);
  }

  std::uint32_t read(std::string_view name) {
    return station.read(reference("DB9." + std::string(name))).value_or(0xDEAD);
  }
  std::int32_t number(std::string_view name) { return static_cast<std::int32_t>(read(name)); }
  void set(std::string_view name, std::int64_t value) {
    EXPECT_TRUE(
        station.write(reference("DB9." + std::string(name)), static_cast<std::uint32_t>(value)))
        << name;
  }
  std::uint32_t operand(std::string_view name) {
    return station.read(reference(name)).value_or(0xDEAD);
  }
  void write(std::string_view name, std::uint32_t value) { station.write(reference(name), value); }
  void call() { station.advanceCycles(1); }
  void wait(std::int64_t ms) {
    station.advanceTo(station.now() + Duration::milliseconds(ms));
    station.settle();
  }
  // A bit for one call; what STATUS says then.
  std::uint32_t press(std::string_view bit) {
    set(bit, 1);
    call();
    set(bit, 0);
    const std::uint32_t status = read("STATUS");
    call();
    return status;
  }
  std::uint32_t job(std::int32_t id, std::int32_t value = 0) {
    set("JOB_ID", id);
    set("JOB_VAL", value);
    set("JOB_REQ", 1);
    call();
    set("JOB_REQ", 0);
    const std::uint32_t status = read("JOB_STAT");
    call();
    return status;
  }
  std::uint32_t run(std::int32_t mode, std::string_view bit, std::int32_t target = 0) {
    set("MODE_IN", mode);
    set("TARGET", target);
    call();
    return press(bit);
  }
  // The number of the cycle of 4 ms, counted from the first one behind `start`, in which it becomes
  // true; looked at in each cycle of OB 1.
  std::int64_t cycleOf(Instant start, const std::function<bool()>& holds) {
    constexpr std::int64_t kCycle = 4'000'000;
    const std::int64_t first = start.ns / kCycle + 1;
    for (int i = 0; i < 200'000; ++i) {
      if (holds()) return station.now().ns / kCycle - first;
      station.advanceCycles(1);
    }
    return -1;
  }
  std::int64_t untilSet(Instant start, std::string_view bit, bool level = true) {
    const address::Reference place = reference("DB9." + std::string(bit));
    return cycleOf(start, [&] { return (station.read(place).value_or(0) != 0) == level; });
  }
  double plantValue(std::string_view name) {
    const plant::Plants& plants = *station.plants();
    return plants.value({0, *plants.configuration().plants[0].kind->signal(name)});
  }
  void plantSet(std::string_view name, double value) {
    plant::Plants& plants = *station.plants();
    plants.set(*station.rack(), {0, *plants.configuration().plants[0].kind->signal(name)}, value,
               station.now());
  }
  bool output(std::uint32_t number) {
    return station.rack()->level(*station.rack()->terminal("2.2", io::Side::DigitalOutput, number));
  }
  double volts() {
    return station.rack()->amount(*station.rack()->terminal("2.3", io::Side::AnalogOutput, 0));
  }
  address::Reference reference(std::string_view operand) const {
    step7::CompileOptions compiling;
    compiling.model = &defaultCpuModel();
    const auto result = step7::resolve(operand, *program_, compiling, {});
    EXPECT_TRUE(result) << operand;
    return result ? *result : address::Reference{};
  }

 private:
  std::shared_ptr<const block::Program> program_;

  static std::string text(AxisOutput output, std::string_view more) {
    const std::string sfb = output == AxisOutput::Analog ? "44" : "46";
    return "DATA_BLOCK DB 9 SFB " + sfb + "\nBEGIN\nEND_DATA_BLOCK\n" + std::string(more) +
           ob(1, "U M 100.0; SPB ende; CALL SFB " + sfb + ", DB 9; U BIE; = M 101.0; ende: NOP 0;");
  }
  static io::Module onBoard(std::uint32_t subslot) {
    io::Module module;
    module.type = onBoardType(defaultCpuModel(), subslot);
    module.slot = 2;
    module.subslot = subslot;
    module.parameters = io::Parameters::of(*module.type);
    return module;
  }
  Options optionsOf(const AxisChannel& axis, const PlantParameters& plant, bool diagnostics,
                    Engine engine) const {
    io::Module digital = onBoard(2), analog = onBoard(3), positioning = onBoard(5);
    digital.parameters.inputDelay = Duration::microseconds(100);
    analog.parameters.analogOutputs[0].range = nullptr;
    positioning.parameters.axis = axis;
    positioning.parameters.diagnosticInterrupt = diagnostics;
    Problems problems;
    Options options;
    options.hardware = io::configure({digital, analog, positioning}, defaultCpuModel(), problems);
    options.plants.plants.push_back(axisPlant(axis, plant, *options.hardware));
    options.program = program_;
    options.engine = engine;
    return options;
  }
  static plant::PlantSettings axisPlant(const AxisChannel& axis, const PlantParameters& wanted,
                                        const io::Configuration& hardware) {
    plant::PlantSettings settings;
    settings.name = "Axis";
    settings.kind = plant::findKind("axis");
    settings.step = settings.kind->step;
    for (const plant::Parameter& row : settings.kind->parameters) {
      const auto found = wanted.find(std::string(row.key));
      double value = found == wanted.end() ? row.standard : found->second;
      if (row.key == "contactors" && axis.output == AxisOutput::Digital)
        value = axis.digitalControl;
      if (row.key == "direction_signal")
        value = axis.analogControl == io::AnalogControl::WithDirection ? 1 : 0;
      settings.parameters.push_back(value);
    }
    const io::Rack rack(hardware);
    const auto wire = [&](std::string_view signal, std::string_view module, io::Side side,
                          std::uint32_t channel) {
      plant::Wire one;
      one.signal = *settings.kind->signal(signal);
      one.end = *rack.terminal(module, side, channel);
      settings.wires.push_back(one);
    };
    std::uint32_t input = 0;
    for (const char* signal : {"A", "B", "N", "WORKPIECE", "REFERENCE"})
      wire(signal, "2.2", io::Side::DigitalInput, input++);
    if (axis.output == AxisOutput::Digital) {
      std::uint32_t output = 8;
      for (const char* signal : {"Q0", "Q1", "Q2", "Q3"})
        wire(signal, "2.2", io::Side::DigitalOutput, output++);
      return settings;
    }
    wire("SETPOINT", "2.3", io::Side::AnalogOutput, 0);
    wire("ENABLE", "2.2", io::Side::DigitalOutput, 6);
    if (axis.analogControl == io::AnalogControl::WithDirection)
      wire("DIRECTION", "2.2", io::Side::DigitalOutput, 7);
    return settings;
  }

 public:
  Station station;
};

}  // namespace merker::station::test
