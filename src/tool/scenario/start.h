// Starts of a PLC for tests, and steps of time between which values are looked at.
#pragma once

#include <string>
#include <vector>

#include "plc/controller.h"

namespace merker::simulator {

// A startup OB that never ends is ended by nothing on the real CPU (S7-STATE-11); whoever waits for
// it must end.
constexpr Duration kLongestStartup = Duration::seconds(60);

// The PLC of a scenario, or one of several, with its name.
struct NamedPlc {
  std::string name;  // empty: it is the only one
  controller::Controller* plc = nullptr;
};

// Of either kind.
using Start = bool (controller::Controller::*)();

// Restart, and the startup OBs up to RUN, at most `longest`. False if the PLC refuses.
bool restart(controller::Controller& plc, Start how, Duration longest = kLongestStartup);

// Memory reset and start. Why no scenario can begin: the start is refused, or its OB does not end;
// else empty. One that ends in STOP, by SFC 46 or a fault, is no refusal (S7-STATE-08).
std::string refusal(controller::Controller& plc, Duration longest = kLongestStartup);
// The same of several, which start at the same time: one reason for each.
std::vector<std::string> refusals(const std::vector<NamedPlc>& plcs,
                                  Duration longest = kLongestStartup);
// The same up to mode RUN. The reason if the CPU does not get there.
std::string startFresh(controller::Controller& plc, Duration longest = kLongestStartup);

// To the next cycle boundary or state change, at most to `end`.
void advanceToNextLook(controller::Controller& plc, Instant end);

}  // namespace merker::simulator
