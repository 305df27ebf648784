#include "address/block_id.h"

#include <fmt/format.h>

namespace merker {

std::string_view name(BlockKind kind) {
  switch (kind) {
    case BlockKind::UDT:
      return "UDT";
    case BlockKind::OB:
      return "OB";
    case BlockKind::DB:
      return "DB";
    case BlockKind::SDB:
      return "SDB";
    case BlockKind::FC:
      return "FC";
    case BlockKind::SFC:
      return "SFC";
    case BlockKind::FB:
      return "FB";
    case BlockKind::SFB:
      return "SFB";
    case BlockKind::PB:
      return "PB";
    case BlockKind::SB:
      return "SB";
  }
  return "?";
}

std::string toString(BlockId id) { return fmt::format("{} {}", name(id.kind), id.number); }

}  // namespace merker
