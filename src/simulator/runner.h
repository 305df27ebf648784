// Runs one scenario on a station.
#pragma once

#include <string>

#include "simulator/scenario.h"
#include "simulator/test_result.h"

namespace merker::simulator {

// Memory reset and start up to mode RUN. The reason if the CPU does not get there.
std::string startFresh(controller::Controller& plc);

// To the next cycle boundary or state change, at most to `end`.
void advanceToNextLook(controller::Controller& plc, Instant end);

// `scenario` is resolved against the station's program. Ends at the first failure. A STOP through a
// fault that the scenario does not speak of (expect mode, expect diagnostics) is a failure too.
TestResult runScenario(const Scenario& scenario, controller::Controller& plc);

}  // namespace merker::simulator
