#include "mc5/range.h"

namespace merker::mc5 {
namespace {

constexpr std::uint32_t kImageBytes = 128, kFlagBytes = 256, kDataWords = 256, kCells = 32;

std::uint32_t bytesOf(Width width) {
  return width == Width::Double ? 4 : width == Width::Word ? 2 : 1;
}

Range memoryRange(const Operand& operand) {
  if (operand.area == Area::Data)
    return {0, operand.width == Width::Double ? kDataWords - 2 : kDataWords - 1, 15};
  const std::uint32_t bytes = operand.area == Area::Flag ? kFlagBytes : kImageBytes;
  return {0, bytes - bytesOf(operand.width), 7};
}

Range countRange(Operation operation) {
  switch (operation) {
    case Operation::SHIFT_LEFT_W:
    case Operation::SHIFT_RIGHT_W:
    case Operation::SHIFT_SIGN_W:
      return {0, 15, 0};
    case Operation::SHIFT_LEFT_D:
    case Operation::SHIFT_SIGN_D:
      return {0, 32, 0};
    case Operation::INCREMENT:
    case Operation::DECREMENT:
      return {1, 255, 0};
    default:  // BLD, TNB, TNW; the number of LIR and TIR is not checked (S5-SYS-02)
      return {0, 255, 0};
  }
}

}  // namespace

Range rangeOf(const Instruction& instruction) {
  const Operand& operand = instruction.operand;
  switch (operand.kind) {
    case OperandKind::Memory:
      if (instruction.operation == Operation::SUBSTITUTE) return {0, 254, 0};  // S5-PROC-01
      return memoryRange(operand);
    case OperandKind::Timer:
    case OperandKind::Counter:
      return {0, kCells - 1, 15};
    case OperandKind::Count:
      return countRange(instruction.operation);
    case OperandKind::Block:
      return {operand.block == BlockType::Db ? 1u : 0u, 255, 0};
    case OperandKind::Formal:
      return {1, 40, 0};  // S5-FB-05
    default:
      return {0, 0xFFFFFFFF, 0xFF};
  }
}

bool inRange(const Instruction& instruction) {
  const Operand& operand = instruction.operand;
  const Range range = rangeOf(instruction);
  return operand.value >= range.lowest && operand.value <= range.highest &&
         operand.bit <= range.highestBit;
}

}  // namespace merker::mc5
