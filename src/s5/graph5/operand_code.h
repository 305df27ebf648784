// An operand of STEP 5 as the bytes that `graph` keeps for us, and what it is for KOP and FUP.
#pragma once

#include <string>

#include "graph/statement.h"
#include "mc5/instruction.h"

namespace merker::graph5 {

graph::Operand operandOf(const mc5::Operand& operand);
mc5::Operand machineOperand(const graph::Operand& operand);

graph::Op operationOf(mc5::Operation operation);
mc5::Operation machineOperation(graph::Op op);

}  // namespace merker::graph5
