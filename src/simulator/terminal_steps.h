// Steps that speak of modules: faults, and signals at terminals (docs/formats/scenario.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/problem.h"
#include "block/check.h"
#include "io/rack.h"

namespace merker::simulator {

// fault MODULE KIND [channel N] [off]
struct FaultStep {
  std::string module;
  Position position;  // of the module's name
  std::string words;  // the fault as written
  Position wordsPosition;
  io::FaultKind kind = io::FaultKind::Defect;  // of a SIMATIC S7: after resolving
  std::optional<std::uint32_t> channel;
  bool there = true;
};

// A terminal and the value it gets or should have: Panel.DI3 = 1, "Fill level".AI0 = 12mA.
struct TerminalValue {
  std::string text;  // as written: "Panel.DI3"
  Position position;
  std::string module;
  io::Side side = io::Side::DigitalInput;
  std::uint32_t channel = 0;
  std::string value;
  Position valuePosition;
  double amount = 0;  // after resolving: a level as 0 or 1, else in the unit of the range
};

using PositionOf = std::function<Position(std::string_view)>;

// Texts are views into the file. False, and a problem, if they are wrong.
bool parseFault(std::string_view text, FaultStep& step, const PositionOf& at, Problems& problems);
bool parseTerminal(std::string_view terminal, std::string_view value, TerminalValue& result,
                   const PositionOf& at, Problems& problems);

// Whether the modules have this; `hardware` is null without a hardware configuration.
void resolve(FaultStep& step, const io::Configuration* hardware, Problems& problems);
void resolve(TerminalValue& terminal, const io::Configuration* hardware, Problems& problems);
// Only to be looked at: without a value.
void resolvePlace(const TerminalValue& terminal, const io::Configuration* hardware,
                  Problems& problems);

// Both on resolved steps. `set`: the reason if an output terminal was to be set, else empty.
void apply(const FaultStep& step, io::Rack& rack);
std::string set(const TerminalValue& terminal, io::Rack& rack, Instant now);

// Amounts are equal when they differ by less than a thousandth of the range: outputs have steps.
bool holds(const TerminalValue& terminal, block::Relation relation, const io::Rack& rack);
std::string actualValue(const TerminalValue& terminal, const io::Rack& rack);
// A level as 0 or 1, an amount in the unit of its range.
double presentValue(const TerminalValue& terminal, const io::Rack& rack);

}  // namespace merker::simulator
