#include "mc5/block_id.h"

#include <algorithm>
#include <array>

namespace merker::mc5 {
namespace {

// In the order of BlockType.
constexpr std::array kKinds{BlockKind::OB, BlockKind::PB, BlockKind::SB, BlockKind::FB,
                            BlockKind::DB};

}  // namespace

merker::BlockId neutralId(BlockId id) {
  return {kKinds[static_cast<std::size_t>(id.type)], id.number};
}

std::optional<BlockId> step5Id(merker::BlockId id) {
  const auto found = std::ranges::find(kKinds, id.kind);
  if (found == kKinds.end()) return std::nullopt;
  return BlockId{static_cast<BlockType>(found - kKinds.begin()), id.number};
}

std::string toString(BlockId id) { return merker::toString(neutralId(id)); }

}  // namespace merker::mc5
