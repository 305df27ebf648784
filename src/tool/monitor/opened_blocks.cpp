#include "monitor/opened_blocks.h"

#include <utility>

#include "mc7/disassembly.h"
#include "monitor/code_map.h"

namespace merker::monitor {

using mc7::OperandKind;
using mc7::Operation;

OpenedBlocks::OpenedBlocks(const block::Block& block) {
  for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German)) {
    const auto decoded = mc7::decode(line.bytes);
    if (!decoded || line.kind != mc7::LineKind::Instruction) continue;
    const mc7::Operand& operand = decoded->instruction.operand;
    if (operand.kind != OperandKind::Jump) continue;
    const std::uint32_t target = line.offset + 2 * operand.value;  // words, two's complement
    if (beginsStatement(block, target)) targets_.insert(target);
  }
}

void OpenedBlocks::executed(const mc7::Instruction& one) {
  if (one.operation == Operation::SWAP_DB) std::swap(db_, di_);
  if (one.operation != Operation::OPEN) return;
  const bool known = one.operand.kind == OperandKind::Block;
  (one.operand.reg == 1 ? di_ : db_) = known ? static_cast<std::int32_t>(one.operand.value) : -1;
}

}  // namespace merker::monitor
