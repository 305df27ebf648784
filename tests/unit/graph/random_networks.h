// Random networks as an editor might leave them: groups of one, nested at will, pins without
// operands, no brackets and joins set.
#pragma once

#include <rapidcheck.h>

#include "graph/network.h"
#include "graph/rules.h"

namespace merker::graph::test {

constexpr std::uint32_t kFirstWire = 160;  // L 20.0

// Every coil, connector and box has an operand of its own.
rc::Gen<Network> networks(const Rules& rules);
Operand bit(std::uint32_t number);

}  // namespace merker::graph::test
