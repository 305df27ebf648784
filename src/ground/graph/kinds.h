// What nodes, coils and operands of several kinds have in common.
#pragma once

#include "graph/network.h"

namespace merker::graph {

inline bool isGroup(const Node& node) {
  return node.kind == NodeKind::Series || node.kind == NodeKind::Parallel ||
         node.kind == NodeKind::Xor;
}
inline bool isUnbracketedGroup(const Node& node) { return isGroup(node) && !node.bracketed; }

// NOT, an edge and a connector act on all of the signal before them.
inline bool actsOnSignal(const Node& node) {
  return node.kind == NodeKind::Not || node.kind == NodeKind::Edge ||
         node.kind == NodeKind::Connector;
}

inline bool isCompare(const Node& node) {
  return node.kind == NodeKind::Box && node.element->row.kind == ElementClass::Compare;
}
// A box that takes the signal before it; a comparison makes one.
inline bool takesSignal(const Node& node) { return node.kind == NodeKind::Box && !isCompare(node); }

inline bool isRail(const Coil& coil) { return coil.element->row.kind == ElementClass::RailCoil; }

inline bool isWire(const Operand& operand) { return operand.kind == OperandKind::Wire; }

// A rung goes on elsewhere from there, too.
inline bool isBranch(const Node& node) {
  return node.kind == NodeKind::Connector && isWire(node.operand);
}

}  // namespace merker::graph
