// What is put on a card comes back from it (S7-MEM-02, S7-MEM-03).
#include "card.h"

#include <fstream>

namespace merker::store::test {
namespace {

class Card : public CardTest {};

TEST_F(Card, IsEmptyWhenNew) {
  for (int opened = 0; opened < 2; ++opened) {
    const auto card = MemoryCard::open(folder_ + "/new/folder");
    ASSERT_TRUE(card);
    EXPECT_TRUE(card->empty());
    EXPECT_FALSE(card->retentive());
  }
}

TEST_F(Card, HoldsLoadMemory) {
  {
    auto card = MemoryCard::open(folder_);
    ASSERT_TRUE(card);
    const auto done = card->download(loadMemory());
    ASSERT_TRUE(done);
    EXPECT_TRUE(done->anotherCpu);
    EXPECT_EQ(done->loaded.size(), 3u);
  }
  const auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  EXPECT_FALSE(card->empty());
  EXPECT_EQ(card->loadMemory().cpu, "314C-2 PtP");
  EXPECT_EQ(card->loadMemory().configuration, loadMemory().configuration);
  const block::Program& program = card->loadMemory().program;
  ASSERT_EQ(program.size(), 3u);
  EXPECT_EQ(program.at({BlockKind::FC, 1}).code, functionBlock(1, 7).code);
  EXPECT_EQ(program.at({BlockKind::DB, 1}).actualData, dataBlock(1, 600, 1).actualData);
  EXPECT_TRUE(program.at({BlockKind::DB, 2}).attributes.readOnly);
  EXPECT_FALSE(program.at({BlockKind::DB, 1}).attributes.readOnly);
}

TEST_F(Card, KeepsRetentiveData) {
  {
    auto card = MemoryCard::open(folder_);
    ASSERT_TRUE(card);
    ASSERT_TRUE(card->download(loadMemory()));
    for (std::uint8_t seed = 3; seed <= 5; ++seed) EXPECT_FALSE(card->save(retentiveData(seed)));
  }
  const auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  ASSERT_TRUE(card->retentive());
  EXPECT_EQ(*card->retentive(), withoutCount(retentiveData(5)));
}

// Shorter, longer, gone: SFC 22 and 23 change data blocks in RUN.
TEST_F(Card, DataBlocksChangeTheirLength) {
  block::RetentiveData data = retentiveData(3);
  {
    auto card = MemoryCard::open(folder_);
    ASSERT_TRUE(card);
    ASSERT_TRUE(card->download(loadMemory()));
    EXPECT_FALSE(card->save(data));
    data.dataBlocks[0].bytes.resize(100);
    data.dataBlocks[1].bytes.resize(1000, 0x44);
    data.dataBlocks.pop_back();
    EXPECT_FALSE(card->save(data));
  }
  const auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  EXPECT_EQ(card->retentive()->dataBlocks, data.dataBlocks);
}

TEST_F(Card, BelongsToOneAtATime) {
  auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  EXPECT_EQ(refusal(), ProblemCode::P1004);
  EXPECT_FALSE(card->save(retentiveData(1)));
}

TEST_F(Card, AFileIsNoCard) {
  std::ofstream(folder_) << "text";
  EXPECT_EQ(refusal(), ProblemCode::P1002);
}

TEST_F(Card, ABlockThatIsTooLong) {
  auto card = MemoryCard::open(folder_);
  ASSERT_TRUE(card);
  LoadMemory load = loadMemory();
  load.program[{BlockKind::DB, 3}] = dataBlock(3, 65536, 0);
  const auto done = card->download(load);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ProblemCode::P1008);
  EXPECT_TRUE(card->empty());
}

}  // namespace
}  // namespace merker::store::test
