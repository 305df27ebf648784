// What an element must have and the user has not given: it is written as missing.
#pragma once

#include "graph/network.h"
#include "graph/read.h"
#include "graph/rules.h"

namespace merker::graph {

void complete(Node& node);
// Parameters of a CALL whose logic is gone are not given any more.
void dropEmptyParameters(Node& call);
void complete(Coil& coil);
// Rungs have logic, but for coils at the rail and those of a copied part, and all but the last a
// coil, or end with a box.
void complete(Network& network, const Rules& rules, Unfinished unfinished);

}  // namespace merker::graph
