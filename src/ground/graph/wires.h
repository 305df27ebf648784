// Where rungs branch: a connector writes a temporary bit, other rungs begin with it.
#pragma once

#include <functional>

#include "graph/network.h"

namespace merker::graph {

// The wires that connectors of the node write, in their order.
void collectWires(const Node& node, std::vector<std::uint32_t>& wires);
// Whether a contact of the node reads the wire.
bool usesWire(const Node& node, std::uint32_t wire);
// Calls `visit` for every node below this one, and for itself first.
void visit(const Node& node, const std::function<void(const Node&)>& visit);

}  // namespace merker::graph
