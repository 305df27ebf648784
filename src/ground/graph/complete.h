// What an element must have and the user has not given: it is written as missing.
#pragma once

#include "graph/network.h"
#include "graph/rules.h"

namespace merker::graph {

void complete(Node& node);
// Parameters of a CALL whose logic is gone are not given any more.
void dropEmptyParameters(Node& call);
void complete(Coil& coil);
// Rungs in the middle of a network have logic and a coil, or end with a box.
void complete(Network& network, const Rules& rules);

}  // namespace merker::graph
