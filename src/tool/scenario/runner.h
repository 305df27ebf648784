// Runs one scenario on a station.
#pragma once

#include <functional>
#include <string>

#include "scenario/scenario.h"
#include "scenario/start.h"
#include "scenario/test_result.h"

namespace merker::simulator {

// `scenario` is resolved against the station's program. Ends at the first failure. A STOP through a
// fault that the scenario does not speak of (expect mode, expect diagnostics) is a failure too.
TestResult runScenario(const Scenario& scenario, controller::Controller& plc);
// The same with several PLCs, at least one, which move through time together and start together.
// `begun` is called between the start and the first step; what it returns, unless empty, is a
// failure.
using Begun = std::function<std::string()>;
TestResult runScenario(const Scenario& scenario, const std::vector<NamedPlc>& plcs,
                       const Begun& begun = {});

// Behind which step a scenario is left: that of this line or, with 0, the one after which the PLC
// is in STOP. A failure leaves it, too.
struct Until {
  std::uint32_t line = 0;
};
TestResult runUntil(const Scenario& scenario, const Until& until, controller::Controller& plc);

}  // namespace merker::simulator
