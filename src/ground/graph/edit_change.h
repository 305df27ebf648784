// Changes and takes out elements of a network.
#pragma once

#include <optional>

#include "graph/edit.h"
#include "graph/locate.h"

namespace merker::graph {

// The problem if it cannot be; then the network is spoilt.
std::optional<EditProblem> change(const Location& at, const Edit& edit);

}  // namespace merker::graph
