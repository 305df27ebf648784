// A network as ladder.
#pragma once

#include "graph/network.h"
#include "graph/picture.h"
#include "graph/rules.h"
#include "graph/style.h"

namespace merker::graph {

// Ladder has no exclusive OR; a box must be the first thing behind the rail or a branch; NOT turns
// round all that stands before it. What does not fit is drawn as FUP.
bool fitsKop(const Network& network, const Rules& rules);

Picture kop(const Network& network, const Style& style);

}  // namespace merker::graph
