// Before and behind what stands in a network already.
#pragma once

#include <optional>

#include "graph/edit_problem.h"
#include "graph/locate.h"

namespace merker::graph {

Node gate(NodeKind kind, Node first, Node second);
// In the list of the location, where that begins.
void put(const Location& at, Node node);
// What stands before it in its series goes into a box that takes the signal.
std::optional<EditProblem> behind(const Location& at, Node node);
std::optional<EditProblem> before(const Location& at, Node node);

}  // namespace merker::graph
