#include "scenario/terminal_value.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/text.h"
#include "io/amount.h"

namespace merker::simulator {
namespace {

std::string moduleNames(const io::Configuration& hardware) {
  std::string list;
  for (const io::Module& module : hardware.modules)
    list += fmt::format("{}{}{}", list.empty() ? "" : ", ", module.slotText(),
                        module.name.empty() ? "" : fmt::format(" \"{}\"", module.name));
  return list;
}

std::uint32_t channelsOf(const ModuleType& type, io::Side side) {
  const std::array<std::uint32_t, 4> counts{type.digitalInputs, type.digitalOutputs,
                                            type.analogInputs, type.analogOutputs};
  return counts[static_cast<std::size_t>(side)];
}

const MeasuringRange* rangeOf(const io::Configuration& hardware, const io::Module& module,
                              const TerminalValue& terminal) {
  const bool output = terminal.side == io::Side::AnalogOutput;
  if (output && io::isOfAxis(hardware, module, terminal.channel)) return findMeasuringRange("±10V");
  if (terminal.side == io::Side::AnalogInput)
    return module.parameters.analogInputs[terminal.channel].range;
  return module.parameters.analogOutputs[terminal.channel].range;
}

std::optional<double> levelOf(std::string_view text) {
  if (text == "1" || equalsIgnoreCase(text, "true")) return 1;
  if (text == "0" || equalsIgnoreCase(text, "false")) return 0;
  return std::nullopt;
}

// Half the difference below which two values count as equal.
double tolerance(const TerminalValue& value, const io::Rack& rack) {
  const auto terminal = rack.terminal(value.module, value.side, value.channel);
  const MeasuringRange* range = terminal ? rack.range(*terminal) : nullptr;
  return range == nullptr ? 0.5 : (range->high - range->low) / 1000;
}

}  // namespace

const io::Module* findModule(const std::string& name, const Position& position,
                             const io::Configuration* hardware, Problems& problems) {
  if (hardware == nullptr) {
    problems.add(ProblemCode::P0983, position);
    return nullptr;
  }
  const io::Module* module = hardware->find(name);
  if (module == nullptr) problems.add(ProblemCode::P0981, position, name, moduleNames(*hardware));
  return module;
}

bool parseTerminal(std::string_view terminal, std::string_view value, TerminalValue& result,
                   const PositionOf& at, Problems& problems) {
  const auto name = io::parseTerminal(terminal);
  result.text = terminal;
  result.position = at(terminal);
  result.value = value;
  result.valuePosition = at(value.empty() ? terminal : value);
  if (!name) {
    problems.add(ProblemCode::P0952, at(terminal), "a terminal: MODULE.DI0, MODULE.AO1");
    return false;
  }
  result.module = name->module;
  result.side = name->side;
  result.channel = name->channel;
  return true;
}

namespace {

// The module that has it, and the range of an analog terminal; null with a problem.
const io::Module* placeOf(const TerminalValue& terminal, const io::Configuration* hardware,
                          const MeasuringRange*& range, Problems& problems) {
  const io::Module* module = findModule(terminal.module, terminal.position, hardware, problems);
  if (module == nullptr) return nullptr;
  if (terminal.channel >= channelsOf(*module->type, terminal.side)) {
    problems.add(ProblemCode::P0984, terminal.position, module->title(),
                 "terminal " + terminal.text.substr(terminal.text.rfind('.') + 1));
    return nullptr;
  }
  range = isDigital(terminal.side) ? nullptr : rangeOf(*hardware, *module, terminal);
  if (isDigital(terminal.side) || range != nullptr) return module;
  problems.add(ProblemCode::P0984, terminal.position, terminal.text, "range: it is off");
  return nullptr;
}

}  // namespace

void resolvePlace(const TerminalValue& terminal, const io::Configuration* hardware,
                  Problems& problems) {
  const MeasuringRange* range = nullptr;
  placeOf(terminal, hardware, range, problems);
}

void resolve(TerminalValue& terminal, const io::Configuration* hardware, Problems& problems) {
  const MeasuringRange* range = nullptr;
  if (placeOf(terminal, hardware, range, problems) == nullptr) return;
  const auto amount =
      range == nullptr ? levelOf(terminal.value) : io::parseAmount(terminal.value, range->quantity);
  if (!amount)
    problems.add(ProblemCode::P0985, terminal.valuePosition, terminal.value,
                 range == nullptr ? std::string("a digital one is 0 or 1")
                                  : fmt::format("{} is measured in {}, for example {}",
                                                terminal.text, unitOf(range->quantity),
                                                io::formatAmount(range->high, range->quantity)));
  terminal.amount = amount.value_or(0);
}

std::string set(const TerminalValue& value, io::Rack& rack, Instant now) {
  const auto terminal = rack.terminal(value.module, value.side, value.channel);
  if (!terminal || value.side == io::Side::DigitalOutput || value.side == io::Side::AnalogOutput)
    return fmt::format("{} is an output; only inputs can be set", value.text);
  if (isDigital(value.side))
    rack.setLevel(*terminal, value.amount != 0, now);
  else
    rack.setAmount(*terminal, value.amount, now);
  return {};
}

double presentValue(const TerminalValue& value, const io::Rack& rack) {
  const auto terminal = rack.terminal(value.module, value.side, value.channel);
  if (!terminal) return 0;
  return isDigital(value.side) ? double(rack.level(*terminal)) : rack.amount(*terminal);
}

bool holds(const TerminalValue& value, block::Relation relation, const io::Rack& rack) {
  const double is = presentValue(value, rack);
  const bool equal = std::abs(is - value.amount) <= tolerance(value, rack);
  switch (relation) {
    case block::Relation::Equal:
    case block::Relation::About:
      return equal;
    case block::Relation::NotEqual:
      return !equal;
    case block::Relation::Less:
      return is < value.amount;
    case block::Relation::LessEqual:
      return is <= value.amount;
    case block::Relation::Greater:
      return is > value.amount;
    case block::Relation::GreaterEqual:
      return is >= value.amount;
  }
  return false;
}

std::string actualValue(const TerminalValue& value, const io::Rack& rack) {
  const auto terminal = rack.terminal(value.module, value.side, value.channel);
  const MeasuringRange* range = terminal ? rack.range(*terminal) : nullptr;
  const double is = presentValue(value, rack);
  return range == nullptr ? fmt::format("{}", is != 0 ? 1 : 0)
                          : io::formatAmount(is, range->quantity);
}

}  // namespace merker::simulator
