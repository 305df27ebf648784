#include "mc5/parameter_list.h"

namespace merker::mc5 {

bool callsFunctionBlock(const Instruction& instruction) {
  return instruction.operand.kind == OperandKind::Block &&
         instruction.operand.block == BlockType::Fb;
}

std::optional<std::uint32_t> endOfList(std::span<const std::uint16_t> code, std::uint32_t jump) {
  constexpr std::uint32_t kJump = 0x2D00, kFarthest = 127;  // SPA = (9.5)
  if (jump >= code.size() || (code[jump] & 0xFF00u) != kJump) return std::nullopt;
  const std::uint32_t distance = code[jump] & 0xFFu;
  const bool forwards = distance > 0 && distance <= kFarthest;
  if (!forwards || jump + distance > code.size()) return std::nullopt;
  return jump + distance;
}

}  // namespace merker::mc5
