// What can be looked at while a PLC runs, by its text: "MW 10", "plant Oven.PV",
// "terminal 2.2.DO0", "axis.position".
#pragma once

#include <string_view>
#include <vector>

#include "address/reference.h"
#include "plant/configuration.h"
#include "scenario/axis_term.h"
#include "scenario/plant_value.h"
#include "scenario/term.h"
#include "scenario/terminal_value.h"

namespace merker::simulator {

struct Watched {
  std::vector<address::Reference> operands;
  std::vector<PlantValue> plants;          // resolved
  std::vector<TerminalValue> terminals{};  // the same
  std::vector<AxisTerm> axis{};            // the same

  // Whether some of it may change beside a cycle that changes nothing: plants, what they wire to
  // terminals, and inputs of the periphery.
  bool movesByItself() const;
};

// What the texts can name. `hardware`: null without a hardware configuration.
struct Watchable {
  const Resolver& resolver;
  const plant::Configuration& plants;
  const io::Configuration* hardware;
};

// Adds what `part` names. Timers and counters come with their value as LC loads it.
void readWatchable(std::string_view part, const Position& position, const Watchable& from,
                   Watched& watched, Problems& problems);

}  // namespace merker::simulator
