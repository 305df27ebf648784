// Kinds and numbers of blocks, of both families. The codes of the S7 are those of its block
// container (MC7 section 8); PB and SB of STEP 5 are in none and have numbers that it does not use.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace merker {

enum class BlockKind : std::uint8_t {
  UDT = 0x00,
  OB = 0x08,
  DB = 0x0A,
  SDB = 0x0B,
  FC = 0x0C,
  SFC = 0x0D,
  FB = 0x0E,
  SFB = 0x0F,
  PB = 0x45,
  SB = 0x46
};

struct BlockId {
  BlockKind kind = BlockKind::OB;
  std::uint16_t number = 0;
  auto operator<=>(const BlockId&) const = default;
};

std::string_view name(BlockKind kind);  // "OB"
std::string toString(BlockId id);       // "FB 12"

}  // namespace merker
