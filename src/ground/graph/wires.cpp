#include "graph/wires.h"

namespace merker::graph {

void visit(const Node& node, const std::function<void(const Node&)>& visitor) {
  visitor(node);
  for (const Node& child : node.children) visit(child, visitor);
  for (const Node& child : node.enable) visit(child, visitor);
  for (const Pin& pin : node.pins)
    for (const Node& child : pin.logic) visit(child, visitor);
  for (const Pin& pin : node.parameters)
    for (const Node& child : pin.logic) visit(child, visitor);
}

void collectWires(const Node& node, std::vector<std::uint32_t>& wires) {
  visit(node, [&wires](const Node& below) {
    if (below.kind == NodeKind::Connector && below.operand.kind == OperandKind::Wire)
      wires.push_back(below.operand.number);
  });
}

bool usesWire(const Node& node, std::uint32_t wire) {
  bool found = false;
  visit(node, [&found, wire](const Node& below) {
    found = found || (below.kind == NodeKind::Contact && below.operand.kind == OperandKind::Wire &&
                      below.operand.number == wire);
  });
  return found;
}

}  // namespace merker::graph
