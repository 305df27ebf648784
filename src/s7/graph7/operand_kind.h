// What an operand is for KOP and FUP.
#pragma once

#include "graph/statement.h"
#include "mc7/instruction.h"

namespace merker::graph7 {

// Jumps excepted: where they lead is to be known first.
graph::OperandKind kindOf(const mc7::Operand& operand);

graph::Op operationOf(mc7::Operation operation);
mc7::Operation operationOf(graph::Op op);

}  // namespace merker::graph7
