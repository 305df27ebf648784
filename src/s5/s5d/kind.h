// What can lie in an S5D file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "mc5/operand.h"
#include "s5d/layout.h"

namespace merker::s5d {

enum class Group : std::uint8_t {
  Code,      // OB, PB, SB, FB, FX
  Data,      // DB, DX
  Comments,  // OK, PK, SK, FK, FKX, DK, DKX
  Formats,   // pre-header of a data block: DV, DVX
  Labels,    // pre-header of a function block: FV, FVX
  Document,  // texts and pictures of STEP 5; what else a file holds
};

struct Kind {
  std::uint8_t mark;  // the type behind 70 70, or the first byte of a pre-header
  bool sync;          // has the synchronisation pattern
  Group group;
  std::string_view name;
  // The block that it is or belongs to; nothing if SINUMERIK 810/820 has no such block.
  std::optional<mc5::BlockType> block;
};

// Of what lies at the beginning of `bytes`; null if it is not in the table.
const Kind* kindAt(Bytes bytes);
// The rows for a block: its own, its comments, its pre-header; null if it has none.
const Kind* kindOf(mc5::BlockType type, Group group);

}  // namespace merker::s5d
