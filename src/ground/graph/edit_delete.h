// Takes elements and rungs out of a network.
#pragma once

#include <optional>

#include "graph/edit.h"
#include "graph/locate.h"

namespace merker::graph {

// The problem if there is nothing to delete. Branches are to be tidied then.
std::optional<EditProblem> remove(Network& network, const Location& at, int pin);
// A coil, or nodes; what comes to a box stays, and goes on where the box was.
void takeElement(const Location& at);
void removeRung(Network& network, const Rung& rung);
void newRung(Network& network, const std::optional<Location>& at, const Rules& rules);

}  // namespace merker::graph
