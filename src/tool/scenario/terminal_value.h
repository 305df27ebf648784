// A terminal of a module and the value that it gets or should have (docs/formats/scenario.md).
#pragma once

#include <string>
#include <string_view>

#include "base/problem.h"
#include "check/check.h"
#include "io/rack.h"
#include "scenario/line.h"

namespace merker::simulator {

// Panel.DI3 = 1, "Fill level".AI0 = 12mA
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

// Texts are views into the file. False, and a problem, if they are wrong.
bool parseTerminal(std::string_view terminal, std::string_view value, TerminalValue& result,
                   const PositionOf& at, Problems& problems);

// The module of this name or slot; null and a problem without it. `hardware` is null without a
// hardware configuration.
const io::Module* findModule(const std::string& name, const Position& position,
                             const io::Configuration* hardware, Problems& problems);
// Whether the module has this terminal, and the value is one of it.
void resolve(TerminalValue& terminal, const io::Configuration* hardware, Problems& problems);
// Only to be looked at: without a value.
void resolvePlace(const TerminalValue& terminal, const io::Configuration* hardware,
                  Problems& problems);

// The reason if an output terminal was to be set, else empty.
std::string set(const TerminalValue& terminal, io::Rack& rack, Instant now);

// Amounts are equal when they differ by less than a thousandth of the range: outputs have steps.
bool holds(const TerminalValue& terminal, block::Relation relation, const io::Rack& rack);
std::string actualValue(const TerminalValue& terminal, const io::Rack& rack);
// A level as 0 or 1, an amount in the unit of its range.
double presentValue(const TerminalValue& terminal, const io::Rack& rack);

}  // namespace merker::simulator
