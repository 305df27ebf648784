#include "icode/region.h"

namespace merker::icode {

std::optional<std::uint32_t> fold(Opcode code, std::uint32_t a, std::uint32_t b) {
  const auto left = static_cast<std::int32_t>(a), right = static_cast<std::int32_t>(b);
  switch (code) {
    case Opcode::BitOf:
      return a >> b & 1;
    case Opcode::Add:
      return a + b;
    case Opcode::Sub:
      return a - b;
    case Opcode::And:
      return a & b;
    case Opcode::Or:
      return a | b;
    case Opcode::Xor:
      return a ^ b;
    case Opcode::Shl:
      return a << b;
    case Opcode::Shr:
      return a >> b;
    case Opcode::Sext16:
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<std::int16_t>(a)));
    case Opcode::Zext16:
      return a & 0xFFFF;
    case Opcode::Zext8:
      return a & 0xFF;
    case Opcode::Equal:
      return a == b ? 1 : 0;
    case Opcode::NotEqual:
      return a != b ? 1 : 0;
    case Opcode::Less:
      return left < right ? 1 : 0;
    case Opcode::LessEqual:
      return left <= right ? 1 : 0;
    case Opcode::Below:
      return a < b ? 1 : 0;
    case Opcode::BelowEqual:
      return a <= b ? 1 : 0;
    default:
      return std::nullopt;
  }
}

}  // namespace merker::icode
