// Starts of a PLC for tests, and steps of time between which values are looked at.
#pragma once

#include <string>

#include "controller/controller.h"
#include "simulator/runner.h"

namespace merker::simulator {

// Of either kind.
using Start = bool (controller::Controller::*)();

// Restart, and the startup OBs up to RUN, at most `longest`. False if the PLC refuses.
bool restart(controller::Controller& plc, Start how, Duration longest = kLongestStartup);

// Memory reset and start. Why no scenario can begin: the start is refused, or its OB does not end;
// else empty. One that ends in STOP, by SFC 46 or a fault, is no refusal (S7-STATE-08).
std::string refusal(controller::Controller& plc, Duration longest = kLongestStartup);

}  // namespace merker::simulator
