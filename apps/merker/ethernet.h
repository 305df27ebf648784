// Network interfaces of this computer, as a CPU with one would tell of them.
#pragma once

#include <optional>
#include <string>

#include "system/communication.h"

namespace merker::app {

// The one with this address; of 0.0.0.0 the first one that others reach. Nothing: there is none.
std::optional<system::EthernetInterface> ethernetAt(const std::string& address);

}  // namespace merker::app
