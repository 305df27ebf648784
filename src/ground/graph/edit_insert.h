// Puts an element into a network.
#pragma once

#include <optional>

#include "graph/edit.h"
#include "graph/locate.h"

namespace merker::graph {

// The problem if it cannot be there; then the network is spoilt. `at`: nothing for the end of the
// network.
std::optional<EditProblem> insert(Network& network, const std::optional<Location>& at,
                                  const Edit& edit, const Rules& rules);

}  // namespace merker::graph
