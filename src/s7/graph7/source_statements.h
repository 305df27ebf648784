// The networks of a block as its source text has them: statements for `graph`, and their places.
#pragma once

#include <vector>

#include "graph/source_network.h"
#include "graph7/source_operand.h"
#include "step7/block_source.h"

namespace merker::graph7 {

// A block has at least one network; code that stands before the first NETWORK is one.
std::vector<graph::SourceNetwork> sourceNetworks(const step7::BlockSource& source,
                                                 const SourceOperands& operands);

}  // namespace merker::graph7
