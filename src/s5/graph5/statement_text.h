// Statements as a listing writes them.
#pragma once

#include <string>

#include "graph/statement.h"

namespace merker::graph5 {

// Without label and colon; `operandAt`: column of the operand behind that of the operation.
std::string statementText(const graph::Statement& statement, std::size_t operandAt);

}  // namespace merker::graph5
