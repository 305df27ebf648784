// B DW, B MW: the next instruction with a parameter that the program computed (9.4.12).
#include "softplc/handlers.h"
#include "softplc/operand_access.h"

namespace merker::sinumerik {
namespace {

using mc5::Area;
using mc5::Instruction;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Operation;

// What may stand behind B (S5-PROC-04, OP-42): operands in memory, cells, jumps of one word,
// blocks, the counts of SLW SRW I D.
bool mayFollow(const Instruction& next) {
  switch (next.operand.kind) {
    case OperandKind::Memory:
      return next.operation != Operation::SUBSTITUTE;
    case OperandKind::Timer:
    case OperandKind::Counter:
    case OperandKind::Block:
      return true;
    case OperandKind::Jump:
      return next.operation != Operation::JUMP_STORED;
    case OperandKind::Count:
      return next.operation == Operation::SHIFT_LEFT_W ||
             next.operation == Operation::SHIFT_RIGHT_W || next.operation == Operation::INCREMENT ||
             next.operation == Operation::DECREMENT;
    default:
      return false;
  }
}

// Low byte: address or number; high byte: bit. E and A differ in bit 7 (S5-PROC-02).
Operand withParameter(Operand operand, std::uint16_t parameter) {
  const std::uint32_t low = parameter & 0xFF;
  operand.value = low;
  if (operand.area == Area::Input || operand.area == Area::Output) {
    operand.area = (low & 0x80) != 0 ? Area::Output : Area::Input;
    operand.value = low & 0x7F;
  }
  if (operand.width == mc5::Width::Bit && operand.kind != OperandKind::Jump) {
    const bool word = operand.area == Area::Data || operand.kind != OperandKind::Memory;
    operand.bit = static_cast<std::uint8_t>(parameter >> 8 & (word ? 0xF : 7));
  }
  if (operand.kind == OperandKind::Jump)
    operand.value = static_cast<std::uint32_t>(static_cast<std::int8_t>(low));
  if (operand.kind == OperandKind::Count || operand.kind == OperandKind::Block) operand.bit = 0;
  return operand;
}

bool process(Processor& p, const Instruction& i) {
  const auto parameter = static_cast<std::uint16_t>(read(p.machine(), i.operand));
  const auto next = p.fetchNext();
  if (!next || !mayFollow(next->instruction)) return p.fail(Alarm::Substitution, p.opcode());
  Instruction instruction = next->instruction;
  instruction.operand = withParameter(instruction.operand, parameter);
  return p.substitute(instruction);
}

constexpr HandlerRow kProcessingRows[] = {{Operation::SUBSTITUTE, process}};

}  // namespace

HandlerRows processingHandlers() { return kProcessingRows; }

}  // namespace merker::sinumerik
