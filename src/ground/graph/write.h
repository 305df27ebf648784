// A network to its statements. Their texts and offsets are not filled in.
#pragma once

#include "graph/network.h"
#include "graph/rules.h"

namespace merker::graph {

Statements write(const Network& network, const Rules& rules);
// The nodes and coils get the numbers of their statements.
Statements writeNumbered(Network& network, const Rules& rules);

}  // namespace merker::graph
