// Virtual time as fast as it goes, with its progress on the screen.
#pragma once

#include <cstdint>

#include "plc/controller.h"

namespace merker::app {

class SerialLink;

// `link`: a recording of a serial line that plays along; null: none.
void runFor(controller::Controller& plc, Duration time, SerialLink* link);
void runCycles(controller::Controller& plc, std::uint64_t count);
// Characters of the recording come at their instants.
void moveTo(controller::Controller& plc, SerialLink* link, Instant end);

}  // namespace merker::app
