// The temporary bits of a network, counted again.
#pragma once

#include "graph/network.h"

namespace merker::graph {

// L 20.0
Operand wireOperand(std::uint32_t number);

// In the order in which they are written, from `first` on; what nobody in the network writes keeps
// its number. Also says which rungs go straight from a branch to their coils.
void numberWires(Network& network, std::uint32_t first);

}  // namespace merker::graph
