// The racks of a station drawn with box characters.
#pragma once

#include <string>
#include <vector>

#include "io/configuration.h"

namespace merker::app {

// All racks, each with what its modules take from the backplane bus.
std::string drawRacks(const io::Configuration& configuration);

// "E 0.0..1.7", "PEW 256..270", "PE 768..783": as a program names them; empty if there is none.
std::string inputText(const io::Module& module);
std::string outputText(const io::Module& module);

}  // namespace merker::app
