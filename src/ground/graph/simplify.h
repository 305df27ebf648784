// Groups that say nothing: of one, of none, of the same kind within each other.
#pragma once

#include "graph/network.h"

namespace merker::graph {

Node missingContact();

// In the trees, in their boxes, in what is at their pins. What acts on a signal that is not there
// gets a contact without operand.
void simplify(std::vector<Node>& logic);

}  // namespace merker::graph
