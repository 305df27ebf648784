#include "graph5/statement_text.h"

#include <fmt/format.h>

#include "graph5/operand_code.h"

namespace merker::graph5 {

std::string statementText(const graph::Statement& statement, std::size_t operandAt) {
  std::string operation(mc5::info(machineOperation(statement.op)).name);
  const graph::Operand& operand = statement.operand;
  std::string text =
      operand.kind == graph::OperandKind::Count ? std::to_string(operand.number) : operand.text;
  if (const auto blank = operation.find(' '); blank != std::string::npos) {  // NOP 0
    text = operation.substr(blank + 1);
    operation.resize(blank);
  }
  return text.empty() ? operation : fmt::format("{:<{}}{}", operation + " ", operandAt, text);
}

}  // namespace merker::graph5
