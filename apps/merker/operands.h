// Operands and assignments in the options of a command: --print "MW 10, A 0.0", --set "E 0.0=1".
#pragma once

#include <string>
#include <vector>

#include "address/reference.h"
#include "base/problem.h"
#include "compilation/network.h"
#include "scenario/assignment.h"
#include "scenario/trace.h"

namespace merker::app {

// Operands, signals of plants and terminals: "A 0.0, plant Oven.PV, terminal 2.2.DO0". `texts` are
// the values of all uses of `option`; problems name the option in place of a file and are printed
// at once. The exit code. Timers and counters come back with their value as LC loads it.
// `hardware`: null without a hardware configuration.
int readWatched(const std::string& option, const std::vector<std::string>& texts,
                const simulator::Resolver& resolver, const plant::Configuration& plants,
                const io::Configuration* hardware, simulator::Watched& watched);
// The same of several stations: Press/A 0.0, plant Press/Oven.PV; each part by itself.
struct StationWatched {
  std::size_t station = 0;
  simulator::Watched what;
};
int readWatched(const std::string& option, const std::vector<std::string>& texts,
                const compilation::NetworkBuild& build,
                const compilation::NetworkOperands& operands, std::vector<StationWatched>& watched);
int readAssignments(const std::string& option, const std::vector<std::string>& texts,
                    const simulator::Resolver& resolver,
                    std::vector<simulator::Assignment>& assignments);

}  // namespace merker::app
