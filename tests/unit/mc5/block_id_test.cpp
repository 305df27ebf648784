#include "mc5/block_id.h"

#include <gtest/gtest.h>

namespace merker::mc5 {
namespace {

// S5-BLK-01: the kinds of blocks, as both families name them.
TEST(BlockId, IsTheSameInBothNotations) {
  constexpr std::pair<BlockType, const char*> kBlocks[] = {{BlockType::Ob, "OB 7"},
                                                           {BlockType::Pb, "PB 7"},
                                                           {BlockType::Sb, "SB 7"},
                                                           {BlockType::Fb, "FB 7"},
                                                           {BlockType::Db, "DB 7"}};
  for (const auto& [type, text] : kBlocks) {
    const BlockId id{type, 7};
    EXPECT_EQ(toString(id), text);
    EXPECT_EQ(merker::toString(neutralId(id)), text);
    EXPECT_EQ(step5Id(neutralId(id)), id);
  }
  EXPECT_EQ(step5Id({BlockKind::FC, 7}), std::nullopt);
}

}  // namespace
}  // namespace merker::mc5
