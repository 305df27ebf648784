// Statements to a network, or the reason why they stay AWL.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "graph/network.h"
#include "graph/reason.h"
#include "graph/rules.h"

namespace merker::graph {

// Allowed: the last rung may lack its coil, as while it is being drawn. Part: what was copied of a
// network may also begin with coils alone. In a network these would take the result of the one
// before, which no picture shows (STEP 7 leaves it AWL).
enum class Unfinished : std::uint8_t { Refused, Allowed, Part };

// Every network it returns is written back as the same statements.
Result<Network, Refusal> read(std::span<const Statement> statements, const Rules& rules,
                              Unfinished unfinished = Unfinished::Refused);

}  // namespace merker::graph
