#include "graph5/statement_text.h"

#include <fmt/format.h>

#include "graph5/operand_code.h"

namespace merker::graph5 {

std::string statementText(const graph::Statement& statement, std::size_t operandAt) {
  const std::string operation(mc5::info(machineOperation(statement.op)).name);
  const graph::Operand& operand = statement.operand;
  const std::string text =
      operand.kind == graph::OperandKind::Count ? std::to_string(operand.number) : operand.text;
  return text.empty() ? operation : fmt::format("{:<{}}{}", operation + " ", operandAt, text);
}

}  // namespace merker::graph5
