// Which stations a client reaches through the S7 server of the first one (S7-NET-15): the low byte
// of the called TSAP, rack * 32 + slot, is then an MPI or PROFIBUS address.
#pragma once

#include <cstdint>
#include <map>

#include "project/network.h"

namespace merker::app {

// Numbers of stations by address. Those that no subnets lead to from the first one are not in it;
// an address that several have is that of the first in the order of the file. The first station is
// reached without it.
std::map<std::uint8_t, std::size_t> routesOf(const project::Network& network);

}  // namespace merker::app
