// Statements to a network, or the reason why they stay AWL.
#pragma once

#include "base/result.h"
#include "graph/network.h"
#include "graph/reason.h"
#include "graph/rules.h"

namespace merker::graph {

// Every network it returns is written back as the same statements.
Result<Network, Refusal> read(std::span<const Statement> statements, const Rules& rules);

}  // namespace merker::graph
