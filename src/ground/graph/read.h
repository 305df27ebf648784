// Statements to a network, or the reason why they stay AWL.
#pragma once

#include <span>

#include "base/result.h"
#include "graph/network.h"
#include "graph/reason.h"
#include "graph/rules.h"

namespace merker::graph {

// Whether a rung may lack its coil or its logic, as while it is being drawn.
enum class Unfinished : bool { Refused, Allowed };

// Every network it returns is written back as the same statements.
Result<Network, Refusal> read(std::span<const Statement> statements, const Rules& rules,
                              Unfinished unfinished = Unfinished::Refused);

}  // namespace merker::graph
