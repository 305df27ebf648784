// Whether an expectation of a scenario holds, and what is there instead.
#pragma once

#include <string>
#include <string_view>

#include "controller/controller.h"
#include "simulator/scenario.h"

namespace merker::simulator {

std::string_view modeName(controller::Mode mode);  // "RUN"
// "6105 Fehlender …, PB 5 word 3; BEF-REG 7509, SAZ …": why, and where the registers stood.
std::string stopText(const controller::Controller& plc);
// ": reason" in STOP, else nothing: what stands behind "the CPU does not start".
std::string because(const controller::Controller& plc);

// LEDs, terminals and plants exist on a SIMATIC S7 station only.
bool needsDevice(const Expectation& e);
bool holds(const Expectation& e, controller::Controller& plc);
// "A 1.2 is 0", "mode is STOP: …"
std::string actual(const Expectation& e, controller::Controller& plc);

}  // namespace merker::simulator
