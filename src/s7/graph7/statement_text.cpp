#include "graph7/statement_text.h"

#include <fmt/format.h>

#include "graph7/operand_code.h"
#include "graph7/operand_kind.h"
#include "mc7/instruction.h"
#include "mc7/operand_text.h"

namespace merker::graph7 {
namespace {

using graph::OperandKind;

std::string bitText(std::uint32_t address) {
  return fmt::format("L {}.{}", address / 8, address % 8);
}

std::string operandText(const graph::Statement& statement, Mnemonics mnemonics,
                        const std::string& label) {
  const graph::Operand& operand = statement.operand;
  switch (operand.kind) {
    case OperandKind::None:
      return {};
    case OperandKind::Wire:
      return bitText(operand.number);
    case OperandKind::Count:
      return std::to_string(operand.number);
    case OperandKind::Status:
      return mc7::operandText(
          {operationOf(statement.op), mc7::number(mc7::OperandKind::StatusBit, operand.number)},
          mnemonics);
    case OperandKind::Label:
      return statement.target >= 0 ? label : operand.text;
    case OperandKind::Bit:
    case OperandKind::Value:
    case OperandKind::Number:
    case OperandKind::Forbidden:
      break;
  }
  return operand.text;
}

std::string callText(const graph::Statement& call, const StatementStyle& style) {
  std::string list;
  for (const graph::Argument& argument : call.arguments) {
    const std::string actual =
        argument.wire >= 0 ? bitText(static_cast<std::uint32_t>(argument.wire)) : argument.text;
    if (actual.empty()) continue;
    list += fmt::format("{}\n{}  {} := {}", list.empty() ? "" : ",", style.indent, argument.name,
                        actual);
  }
  const std::string head = fmt::format("{:<{}}{}", "CALL ", style.operandAt, call.operand.text);
  return list.empty() ? head : fmt::format("{} ({})", head, list);
}

}  // namespace

std::string statementText(const graph::Statement& statement, const StatementStyle& style,
                          const std::string& label) {
  if (statement.op == graph::Op::CALL) return callText(statement, style);
  const mc7::OperationInfo& row = mc7::info(operationOf(statement.op));
  std::string mnemonic(style.mnemonics == Mnemonics::German ? row.de : row.en);
  std::string operand = operandText(statement, style.mnemonics, label);
  if (const auto blank = mnemonic.find(' '); blank != std::string::npos) {  // NOP 0
    operand = mnemonic.substr(blank + 1);
    mnemonic.resize(blank);
  }
  if (operand.empty()) return mnemonic;
  // A mnemonic that is longer than its column keeps a blank behind it.
  return fmt::format("{:<{}}{}", mnemonic + " ", style.operandAt, operand);
}

}  // namespace merker::graph7
