#include "base/bytes.h"
#include "graph7/network_code.h"
#include "graph7/operand_code.h"
#include "graph7/operand_kind.h"
#include "mc7/instruction.h"

namespace merker::graph7 {
namespace {

using graph::OperandKind;

constexpr std::uint32_t kDistanceAt = 2;  // bytes from the beginning of a jump to its distance

constexpr std::uint32_t kEmptyList = 0x700B'0002;  // SPA over no entries

bool takesList(graph::Op op, const mc7::Operand& operand) {
  return (op == graph::Op::UC || op == graph::Op::CC) && operand.kind == mc7::OperandKind::Block &&
         (operand.blockKind == BlockKind::FC || operand.blockKind == BlockKind::SFC);
}

OperandCode operandOf(const graph::Statement& statement) {
  const graph::Operand& operand = statement.operand;
  switch (operand.kind) {
    case OperandKind::None:
      return {};
    case OperandKind::Wire:
      return {{}, mc7::memory(Area::Local, Width::Bit, operand.number)};
    case OperandKind::Status:
      return {{}, mc7::number(mc7::OperandKind::StatusBit, operand.number)};
    case OperandKind::Count:
      return {{}, mc7::number(mc7::OperandKind::ShiftCount, operand.number)};
    case OperandKind::Label:
      if (statement.target >= 0) return {{}, mc7::number(mc7::OperandKind::Jump, 0)};
      break;
    case OperandKind::Bit:
    case OperandKind::Value:
    case OperandKind::Number:
    case OperandKind::Forbidden:
      break;
  }
  return unpack(operand.code);
}

bool append(const graph::Statement& statement, std::vector<std::uint8_t>& out) {
  if (statement.op == graph::Op::CALL) {
    out.insert(out.end(), statement.operand.code.begin(), statement.operand.code.end());
    return true;
  }
  const OperandCode code = operandOf(statement);
  out.insert(out.end(), code.before.begin(), code.before.end());
  if (!mc7::encode({operationOf(statement.op), code.operand}, out)) return false;
  if (takesList(statement.op, code.operand)) appendDWord(out, kEmptyList);
  return true;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> encode(const graph::Statements& statements) {
  std::vector<std::uint8_t> out;
  std::vector<std::size_t> offsets;
  for (const graph::Statement& statement : statements) {
    offsets.push_back(out.size());
    if (!append(statement, out)) return std::nullopt;
  }
  offsets.push_back(out.size());
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (statements[i].target < 0) continue;
    const std::size_t target = offsets[static_cast<std::size_t>(statements[i].target)];
    storeWord(&out[offsets[i] + kDistanceAt],
              static_cast<std::uint32_t>((target - offsets[i]) / 2));
  }
  return out;
}

}  // namespace merker::graph7
