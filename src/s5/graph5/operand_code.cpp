#include "graph5/operand_code.h"

#include <array>

#include "mc5/operand_text.h"

namespace merker::graph5 {
namespace {

using graph::Op;

// Where the two families have different words for the same; the others have the same id.
struct Pair {
  Op op;
  mc5::Operation operation;
};
constexpr Pair kPairs[] = {
    {Op::EQ_I, mc5::Operation::EQUAL_F},   {Op::NE_I, mc5::Operation::UNEQUAL_F},
    {Op::GT_I, mc5::Operation::GREATER_F}, {Op::GE_I, mc5::Operation::GREATER_EQUAL_F},
    {Op::LT_I, mc5::Operation::LESS_F},    {Op::LE_I, mc5::Operation::LESS_EQUAL_F},
    {Op::EQ_D, mc5::Operation::EQUAL_D},   {Op::NE_D, mc5::Operation::UNEQUAL_D},
    {Op::GT_D, mc5::Operation::GREATER_D}, {Op::GE_D, mc5::Operation::GREATER_EQUAL_D},
    {Op::LT_D, mc5::Operation::LESS_D},    {Op::LE_D, mc5::Operation::LESS_EQUAL_D},
    {Op::EQ_R, mc5::Operation::EQUAL_G},   {Op::NE_R, mc5::Operation::UNEQUAL_G},
    {Op::GT_R, mc5::Operation::GREATER_G}, {Op::GE_R, mc5::Operation::GREATER_EQUAL_G},
    {Op::LT_R, mc5::Operation::LESS_G},    {Op::LE_R, mc5::Operation::LESS_EQUAL_G},
    {Op::UC, mc5::Operation::CALL},        {Op::CC, mc5::Operation::CALL_IF}};

// Basic operations that mean the same and that KOP and FUP of STEP 5 use.
constexpr Op kSame[] = {
    Op::AND,      Op::AND_NOT,       Op::OR,         Op::OR_NOT,   Op::AND_OPEN,  Op::OR_OPEN,
    Op::CLOSE,    Op::AND_BEFORE_OR, Op::ASSIGN,     Op::SET_BIT,  Op::RESET_BIT, Op::LOAD,
    Op::LOAD_BCD, Op::TRANSFER,      Op::TIMER_SI,   Op::TIMER_SV, Op::TIMER_SE,  Op::TIMER_SS,
    Op::TIMER_SA, Op::COUNT_UP,      Op::COUNT_DOWN, Op::NOP0,     Op::BLD};

// Behind the call of a function block stands the list of its parameters.
bool isCalledAlone(mc5::BlockType type) {
  return type == mc5::BlockType::Ob || type == mc5::BlockType::Pb || type == mc5::BlockType::Sb;
}

graph::OperandKind kindOf(const mc5::Operand& operand) {
  switch (operand.kind) {
    case mc5::OperandKind::None:
      return graph::OperandKind::None;
    case mc5::OperandKind::Memory:
      return operand.width == mc5::Width::Bit ? graph::OperandKind::Bit : graph::OperandKind::Value;
    case mc5::OperandKind::Timer:
    case mc5::OperandKind::Counter:
      return graph::OperandKind::Number;
    case mc5::OperandKind::Constant:
      return graph::OperandKind::Value;
    case mc5::OperandKind::Count:
      return graph::OperandKind::Count;
    case mc5::OperandKind::Block:
      if (isCalledAlone(operand.block)) return graph::OperandKind::Number;
      break;
    case mc5::OperandKind::Jump:
    case mc5::OperandKind::Formal:
      break;
  }
  return graph::OperandKind::Forbidden;
}

constexpr std::size_t kBytes = 10;

}  // namespace

graph::Operand operandOf(const mc5::Operand& operand) {
  graph::Operand out;
  out.kind = kindOf(operand);
  out.text = mc5::operandText(operand);
  if (out.kind == graph::OperandKind::None) return out;
  out.number = operand.value;
  if (out.kind == graph::OperandKind::Count) return out;
  const std::array<std::uint32_t, kBytes> bytes{static_cast<std::uint32_t>(operand.kind),
                                                static_cast<std::uint32_t>(operand.area),
                                                static_cast<std::uint32_t>(operand.width),
                                                static_cast<std::uint32_t>(operand.format),
                                                static_cast<std::uint32_t>(operand.block),
                                                operand.bit,
                                                operand.value >> 24,
                                                operand.value >> 16 & 0xFF,
                                                operand.value >> 8 & 0xFF,
                                                operand.value & 0xFF};
  for (const std::uint32_t byte : bytes) out.code += static_cast<char>(byte);
  return out;
}

mc5::Operand machineOperand(const graph::Operand& operand) {
  if (operand.kind == graph::OperandKind::Count)
    return {.kind = mc5::OperandKind::Count, .value = operand.number};
  if (operand.code.size() != kBytes) return {};
  const auto byte = [&operand](std::size_t at) {
    return static_cast<std::uint8_t>(operand.code[at]);
  };
  mc5::Operand out;
  out.kind = static_cast<mc5::OperandKind>(byte(0));
  out.area = static_cast<mc5::Area>(byte(1));
  out.width = static_cast<mc5::Width>(byte(2));
  out.format = static_cast<mc5::Format>(byte(3));
  out.block = static_cast<mc5::BlockType>(byte(4));
  out.bit = byte(5);
  for (std::size_t at = 6; at < kBytes; ++at) out.value = out.value << 8 | byte(at);
  return out;
}

graph::Op operationOf(mc5::Operation operation) {
  for (const Pair& pair : kPairs)
    if (pair.operation == operation) return pair.op;
  const auto op = graph::findOp(mc5::info(operation).id);
  for (const Op same : kSame)
    if (op == same) return same;
  return Op::OTHER;
}

mc5::Operation machineOperation(graph::Op op) {
  for (const Pair& pair : kPairs)
    if (pair.op == op) return pair.operation;
  for (std::size_t i = 0; i < mc5::operations().size(); ++i)
    if (mc5::operations()[i].id == graph::name(op)) return static_cast<mc5::Operation>(i);
  return mc5::Operation::NOP1;
}

}  // namespace merker::graph5
