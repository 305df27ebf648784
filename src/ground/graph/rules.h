// What a family allows, and the operands that only it can name.
#pragma once

#include "graph/element.h"

namespace merker::graph {

struct Rules {
  const ElementTable* elements = nullptr;
  int deepestBrackets = 7;  // places in the stack of brackets
  Operand binaryResult;     // BIE: ENO of the box before
  Operand overflow;         // OV
  bool oneBox = false;      // a network has at most one
  bool boxBeforeOr = true;  // ladder shows a box in a branch that is joined to others
  bool branches = true;     // by temporary bits
  bool extended = true;     // NOT, edges, exclusive OR
};

}  // namespace merker::graph
