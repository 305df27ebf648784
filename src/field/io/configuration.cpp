#include "io/configuration.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "io/asi.h"
#include "io/slave.h"
#include "serial/parameters.h"

namespace merker::io {
namespace {

const MeasuringRange* firstOf(std::uint16_t sets) {
  for (const MeasuringRange& range : measuringRanges())
    if ((range.sets & sets) != 0) return &range;
  return nullptr;
}

bool covers(std::optional<std::uint32_t> start, std::uint32_t length, std::uint32_t byte) {
  return start && byte >= *start && byte < *start + length;
}

}  // namespace

Parameters Parameters::of(const ModuleType& type) {
  Parameters parameters;
  parameters.inputDelay = Duration::microseconds(type.inputDelay);
  if (type.kind == ModuleKind::PointToPoint)
    parameters.serial =
        std::make_shared<serial::Parameters>(serial::defaults(serial::Protocol::Ascii));
  for (unsigned i = 0; i < type.analogInputs; ++i)
    parameters.analogInputs[i].range = firstOf(type.rangesOfInput(i));
  for (unsigned i = 0; i < type.analogOutputs; ++i)
    parameters.analogOutputs[i].range = firstOf(type.outputRanges);
  return parameters;
}

std::string Module::slotText() const {
  if (asiCp) return fmt::format("AS{}/{}", rack - kAsiRack, slot);
  if (rack >= kSlaveRack) return fmt::format("DP{}/{}", rack - kSlaveRack, slot);
  if (onBoard()) return fmt::format("{}.{}", slot, subslot);
  return rack == 0 ? fmt::format("{}", slot) : fmt::format("{}/{}", rack, slot);
}

std::string Module::title() const { return merker::title(*type) + (onBoard() ? " on board" : ""); }

const Module* Configuration::find(std::string_view name) const {
  for (const Module& module : modules)
    if (!module.name.empty() && equalsIgnoreCase(module.name, name)) return &module;
  for (const Module& module : modules)
    if (equalsIgnoreCase(module.slotText(), name) ||
        (module.rack == 0 && "0/" + module.slotText() == name))
      return &module;
  return nullptr;
}

bool Configuration::hasInput(std::uint32_t byte) const {
  return std::any_of(modules.begin(), modules.end(), [&](const Module& m) {
    return covers(m.inputStart, m.type->inputBytes, byte);
  });
}

bool Configuration::hasOutput(std::uint32_t byte) const {
  return std::any_of(modules.begin(), modules.end(), [&](const Module& m) {
    return covers(m.outputStart, m.type->outputBytes, byte);
  });
}

const AxisChannel* Configuration::axis() const {
  for (const Module& module : modules)
    if (module.parameters.axis) return &*module.parameters.axis;
  return nullptr;
}

bool isOfAxis(const Configuration& configuration, const Module& module, std::uint32_t output) {
  constexpr std::uint32_t kAnalog = 3;  // sub-module
  const AxisChannel* axis = configuration.axis();
  return axis != nullptr && axis->output == AxisOutput::Analog && module.subslot == kAnalog &&
         output == 0;
}

Channels channels(const Configuration& configuration) {
  Channels sum;
  for (const Module& module : configuration.modules) {
    sum.digitalInputs += module.type->digitalInputs;
    sum.digitalOutputs += module.type->digitalOutputs;
    sum.analogInputs += module.type->analogInputs;
    sum.analogOutputs += module.type->analogOutputs;
  }
  return sum;
}

// Rack 0 is supplied by the CPU, racks 1 to 3 by their interface module (S7-HW-14).
Current current(const Configuration& configuration, std::uint32_t rack) {
  constexpr std::uint32_t kExpansionRack = 800;  // mA
  Current sum;
  sum.possible = rack == 0 ? configuration.model->busCurrent : kExpansionRack;
  for (const Module& module : configuration.modules)
    if (module.rack == rack) sum.taken += module.type->busCurrent;
  return sum;
}

}  // namespace merker::io
