// What an element must have and the user has not given: it is written as missing.
#pragma once

#include "graph/network.h"
#include "graph/rules.h"

namespace merker::graph {

void complete(Node& node);
void complete(Coil& coil);
// Rungs in the middle of a network have logic and a coil, or end with a box.
void complete(Network& network, const Rules& rules);

}  // namespace merker::graph
