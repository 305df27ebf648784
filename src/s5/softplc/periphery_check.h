// The periphery as it is configured: which bytes answer, and what is wrong with it at start-up
// (6100, 6125 … 6128).
#pragma once

#include <optional>

#include "softplc/machine.h"
#include "softplc/surroundings.h"
#include "softplc/trap.h"

namespace merker::sinumerik {

// The first fault; xxx3 is the byte in BCD.
std::optional<Trap> checkModules(const std::vector<Module>& modules);
// Which bytes answer direct access.
void mount(const std::vector<Module>& modules, Periphery& periphery);
bool isDistributed(const std::vector<Module>& modules, unsigned inputByte);

}  // namespace merker::sinumerik
