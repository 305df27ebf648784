// Before and behind what stands in a network already.
#pragma once

#include <optional>

#include "graph/edit_problem.h"
#include "graph/locate.h"

namespace merker::graph {

Node gate(NodeKind kind, Node first, Node second);
// In the list of the location, where that begins.
void put(const Location& at, Node node);
// Whether what is first in it acts on a signal: it cannot stand at the rail.
bool beginsOnSignal(const Node& node);
// Where the signal goes into a box; null: it takes none.
std::vector<Node>* signalInto(Node& node);

// A series comes element by element, one in brackets as a whole. What stands before it goes into
// the box that it begins with.
std::optional<EditProblem> behind(const Location& at, Node node);
std::optional<EditProblem> before(const Location& at, Node node);

}  // namespace merker::graph
