// Operands of the fields of an element, and what stands at its pins.
#pragma once

#include <optional>

#include "graph/edit.h"
#include "graph/locate.h"

namespace merker::graph {

// The logic that is at the pin of a box; null: none can be, or none is.
std::vector<Node>* logicOfPin(Node& box, int pin);

std::optional<EditProblem> setOperand(const Location& at, const Edit& edit);

}  // namespace merker::graph
