// Blocks in segments 5 and 6 (S5-BLK-08, S5-BLK-09, S5-BLK-21, S5-DB-03, S5-DB-16).
#include "softplc/block_memory.h"

#include <gtest/gtest.h>

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

mc5::Block block(BlockType type, std::uint16_t number, std::vector<std::uint16_t> words) {
  mc5::Block b;
  b.id = {type, number};
  b.words = std::move(words);
  return b;
}

// S5-BLK-08, S5-BLK-09
TEST(BlockMemory, HeaderOfFiveWords) {
  BlockMemory memory(100, 100);
  ASSERT_TRUE(memory.load(block(BlockType::Pb, 25, {0x6500})));
  EXPECT_EQ(memory.program()[0], 0x7070u);
  EXPECT_EQ(memory.program()[1] & 0xFF, 0x19u);
  EXPECT_EQ(memory.program()[4], 6u);
  EXPECT_EQ(memory.program()[5], 0x6500u);
  EXPECT_EQ(memory.programUsed(), 6u);
  ASSERT_TRUE(memory.load(block(BlockType::Db, 1, std::vector<std::uint16_t>(10))));
  EXPECT_EQ(memory.dataUsed(), 15u);
}

TEST(BlockMemory, AReplacedBlockLeavesNoGap) {
  BlockMemory memory(100, 100);
  memory.load(block(BlockType::Pb, 1, {0x0000, 0x0000, 0x6500}));
  memory.load(block(BlockType::Pb, 2, {0xFFFF, 0x6500}));
  memory.load(block(BlockType::Pb, 1, {0x6500}));
  EXPECT_EQ(memory.programUsed(), 7u + 6u);
  const Entry& second = memory.find({BlockType::Pb, 2});
  EXPECT_EQ(memory.program()[second.start], 0xFFFFu);
  EXPECT_FALSE(memory.buildLists().has_value());
  EXPECT_TRUE(memory.find({BlockType::Pb, 1}).present);
}

TEST(BlockMemory, WhatFindsNoRoomChangesNothing) {
  BlockMemory memory(20, 20);
  memory.load(block(BlockType::Pb, 1, {0x6500}));
  EXPECT_FALSE(memory.load(block(BlockType::Pb, 1, std::vector<std::uint16_t>(16))));
  EXPECT_EQ(memory.find({BlockType::Pb, 1}).length, 1u);
  EXPECT_FALSE(memory.load(block(BlockType::Ob, 64, {0x6500})));
}

TEST(BlockMemory, DamagedHeadersAreFound) {
  BlockMemory memory(100, 100);
  memory.load(block(BlockType::Pb, 1, {0x6500}));
  memory.load(block(BlockType::Pb, 2, {0x6500}));
  memory.program()[6] = 0x1234;
  auto damage = memory.buildLists();
  ASSERT_TRUE(damage.has_value());
  EXPECT_TRUE(damage->synchronisation);
  EXPECT_EQ(damage->word, 6u);
  memory.program()[6] = kSynchronisation;
  memory.program()[10] = 3;
  damage = memory.buildLists();
  ASSERT_TRUE(damage.has_value());
  EXPECT_FALSE(damage->synchronisation);
}

}  // namespace
}  // namespace merker::sinumerik
