#include "step5/statement_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "mc5/constant.h"

namespace merker::step5 {
namespace {

using mc5::BlockType;
using mc5::OperandKind;
using mc5::Operation;

constexpr std::uint32_t kNoSignedByte = 0x80;  // ADD BF -128: the range is -127..+127 (S5-ARITH-08)
constexpr std::uint32_t kSystemFlags = 25;     // MB 0 to MB 24 (S5-FLAG-12)

bool writesFlag(Operation operation) {
  return operation == Operation::ASSIGN || operation == Operation::SET_BIT ||
         operation == Operation::RESET_BIT || operation == Operation::TRANSFER ||
         operation == Operation::SET_ALWAYS || operation == Operation::RESET_ALWAYS;
}

}  // namespace

bool StatementCheck::allowed(const Statement& s) {
  const mc5::OperationInfo& row = mc5::info(s.instruction.operation);
  const bool formal = s.instruction.operand.kind == OperandKind::Formal;
  const bool only = row.level == mc5::Level::Supplementary || formal;
  if (!only || source_.id.type == BlockType::Fb) return true;
  add(ProblemCode::P1113, s.offset, row.name.size(),
      s.name.empty() ? mc5::text(s.instruction) : fmt::format("{} ={}", row.name, s.name));
  return false;
}

// Limits of the PLC and what is possible but unwise.
void StatementCheck::inspect(const Statement& s) {
  const mc5::Operand& operand = s.instruction.operand;
  // Behind B the number is another one: A DB 0 (9.4.12).
  const bool block = operand.kind == OperandKind::Block;
  if (operand.kind != OperandKind::Jump && !mc5::inRange(s.instruction) && !(block && processed_))
    outside(operand, mc5::rangeOf(s.instruction), s.operandOffset, s.operandLength);
  if (block && !processed_) exists(s);
  const bool flag = operand.kind == OperandKind::Memory && operand.area == mc5::Area::Flag;
  if (flag && operand.value < kSystemFlags && writesFlag(s.instruction.operation))
    add(ProblemCode::P1135, s.operandOffset, s.operandLength, operand.value);
  constant(operand, s.operandOffset, s.operandLength);
  processed_ = s.instruction.operation == Operation::SUBSTITUTE;
}

void StatementCheck::outside(const mc5::Operand& operand, const mc5::Range& range,
                             std::size_t offset, std::size_t length) {
  const bool bit = operand.value >= range.lowest && operand.value <= range.highest;
  add(ProblemCode::P1112, offset, length, bit ? "bit" : "number", bit ? operand.bit : operand.value,
      bit ? fmt::format("0..{}", range.highestBit)
          : fmt::format("{}..{}", range.lowest, range.highest));
}

void StatementCheck::constant(const mc5::Operand& operand, std::size_t offset, std::size_t length) {
  if (operand.kind != OperandKind::Constant) return;
  if (operand.format == mc5::Format::Time && operand.value >> 12 == 0)
    add(ProblemCode::P1136, offset, length);
  if (operand.format == mc5::Format::SignedByte && operand.value == kNoSignedByte)
    add(ProblemCode::P1108, offset, length, "BF", mc5::info(operand.format).range);
}

// A missing FB is an error, its parameters are not known; program and sequence blocks may come
// later.
void StatementCheck::exists(const Statement& s) {
  const mc5::Operand& operand = s.instruction.operand;
  const mc5::BlockId id{operand.block, static_cast<std::uint16_t>(operand.value)};
  const bool code = id.type == BlockType::Pb || id.type == BlockType::Sb;
  if (code && operand.value <= 255 && !blocks_.contains(id))
    add(ProblemCode::P1149, s.operandOffset, s.operandLength, toString(id));
}

}  // namespace merker::step5
