// What a download keeps (S7-MEM-04, S7-LIM-04).
#include "card.h"

namespace merker::store::test {
namespace {

class DownloadTo : public CardTest {
 protected:
  DownloadTo() {
    auto card = MemoryCard::open(folder_);
    EXPECT_TRUE(card->download(loadMemory()));
    EXPECT_FALSE(card->save(retentiveData(7)));
  }
  // Downloads and opens again.
  MemoryCard after(const LoadMemory& load) {
    {
      auto card = MemoryCard::open(folder_);
      auto done = card->download(load);
      EXPECT_TRUE(done);
      done_ = *done;
    }
    return std::move(*MemoryCard::open(folder_));
  }
  Download done_;
};

TEST_F(DownloadTo, TheSameProgramChangesNothing) {
  const MemoryCard card = after(loadMemory());
  EXPECT_FALSE(done_.changed());
  EXPECT_EQ(*card.retentive(), withoutCount(retentiveData(7)));
}

TEST_F(DownloadTo, AnotherBlockKeepsTheData) {
  LoadMemory load = loadMemory();
  load.program[{BlockKind::FC, 1}] = functionBlock(1, 8);
  const MemoryCard card = after(load);
  EXPECT_EQ(done_.loaded, (std::vector{BlockId{BlockKind::FC, 1}}));
  EXPECT_FALSE(done_.anotherCpu);
  EXPECT_EQ(card.loadMemory().program.at({BlockKind::FC, 1}).code, functionBlock(1, 8).code);
  EXPECT_EQ(*card.retentive(), withoutCount(retentiveData(7)));
}

// S7-MEM-04: download loads actual values.
TEST_F(DownloadTo, AChangedDataBlockLosesItsActualValues) {
  LoadMemory load = loadMemory();
  load.program[{BlockKind::DB, 1}] = dataBlock(1, 600, 9);
  const MemoryCard card = after(load);
  block::RetentiveData expected = withoutCount(retentiveData(7));
  expected.dataBlocks.erase(expected.dataBlocks.begin());
  EXPECT_EQ(*card.retentive(), expected);
}

TEST_F(DownloadTo, BlocksThatAreNoLongerThereGo) {
  LoadMemory load = loadMemory();
  load.program.erase({BlockKind::DB, 2});
  const MemoryCard card = after(load);
  EXPECT_EQ(done_.deleted, (std::vector{BlockId{BlockKind::DB, 2}}));
  EXPECT_FALSE(card.loadMemory().program.contains({BlockKind::DB, 2}));
  EXPECT_EQ(card.retentive()->dataBlocks.size(), 2u);
}

TEST_F(DownloadTo, AnAttributeIsAChange) {
  LoadMemory load = loadMemory();
  load.program[{BlockKind::DB, 2}].attributes.readOnly = false;
  after(load);
  EXPECT_EQ(done_.loaded, (std::vector{BlockId{BlockKind::DB, 2}}));
}

TEST_F(DownloadTo, AnotherCpuBeginsAnew) {
  LoadMemory load = loadMemory();
  load.cpu = "314C-2 DP";
  const MemoryCard card = after(load);
  EXPECT_TRUE(done_.anotherCpu);
  EXPECT_FALSE(card.retentive());
}

TEST_F(DownloadTo, AnotherConfigurationKeepsTheData) {
  LoadMemory load = loadMemory();
  load.configuration = "[cpu]\n";
  const MemoryCard card = after(load);
  EXPECT_TRUE(done_.anotherConfiguration);
  EXPECT_EQ(card.loadMemory().configuration, "[cpu]\n");
  EXPECT_EQ(*card.retentive(), withoutCount(retentiveData(7)));
}

}  // namespace
}  // namespace merker::store::test
