// The characters of a serial line as a capture file that network analysers read.
#pragma once

#include <deque>
#include <ostream>

#include "serial/port.h"

namespace merker::app {

// Link type RTAC serial (250): each telegram of one end is a packet, X27 sends (TX), the other end
// is received (RX).
void writePcap(const std::deque<serial::Sighting>& sightings, std::ostream& out);

}  // namespace merker::app
