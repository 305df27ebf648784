// The form of a tree that has one way to be written: what the editor of STEP 7 stores.
#pragma once

#include "graph/network.h"
#include "graph/read.h"
#include "graph/rules.h"

namespace merker::graph {

// Any tree; groups of one and groups in groups of the same kind are dissolved, joins and brackets
// set, temporary bits numbered in the order of their use from `firstWire` on.
Network canonical(Network network, const Rules& rules, std::uint32_t firstWire,
                  Unfinished unfinished = Unfinished::Allowed);

}  // namespace merker::graph
