#include "graph/network.h"

namespace merker::graph {

bool Pin::operator==(const Pin& other) const {
  return open == other.open && logic == other.logic && operand == other.operand;
}

// Where it stands among the statements and how its operands are named is not looked at.
bool Node::operator==(const Node& other) const {
  return kind == other.kind && join == other.join && bracketed == other.bracketed &&
         negated == other.negated && falling == other.falling && operand == other.operand &&
         memory == other.memory && children == other.children && element == other.element &&
         pins == other.pins && continues == other.continues && eno == other.eno &&
         enable == other.enable && parameters == other.parameters && arguments == other.arguments;
}

}  // namespace merker::graph
