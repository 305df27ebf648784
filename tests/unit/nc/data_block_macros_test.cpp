// FB 11 EINR-DB and FB 60 BLOCK-TR.
#include "rig.h"

namespace merker::nc {
namespace {

std::string create(const std::string& blocks, int lastWord) {
  return ":SPA FB 11\nNAME :EINR-DB\nDBAN : KY " + blocks + "\nDWNR : KF " +
         std::to_string(lastWord) + "\n";
}
std::string stopOfCreate(const std::string& blocks, int lastWord) {
  Rig rig;
  rig.start(dataBlock(90, 5) + "OB 20\n" + create(blocks, lastWord) + ":BE\n");
  rig.cycles(1);
  return rig.stop();
}

// S5-FM-07, S5-FM-08, S5-FM-11
TEST(CreateDataBlocks, BlocksOfZeros) {
  Rig rig;
  ASSERT_TRUE(rig.start("OB 20\n" + create("100,3", 9) + create("200,1", 255) + ":BE\n" + "OB 1\n" +
                        create("100,3", 9) + ":BE\n"));
  rig.cycles(1);
  for (std::uint16_t number = 100; number <= 102; ++number) {
    const auto& entry = rig.machine().blocks.find({mc5::BlockType::Db, number});
    ASSERT_TRUE(entry.present);
    EXPECT_EQ(entry.length, 10u);
  }
  EXPECT_EQ(rig.machine().blocks.find({mc5::BlockType::Db, 200}).length, 256u);
  EXPECT_FALSE(rig.machine().blocks.find({mc5::BlockType::Db, 103}).present);
  rig.word(100, 0) = 5;
  rig.cycles(2);
  EXPECT_EQ(rig.stop(), "");
  EXPECT_EQ(rig.word(100, 0), 5u);
}

// S5-FM-05, S5-FM-10
TEST(CreateDataBlocks, Errors) {
  EXPECT_EQ(stopOfCreate("250,6", 9), "");
  EXPECT_EQ(stopOfCreate("250,7", 9), "11/2");
  EXPECT_EQ(stopOfCreate("100,1", -1), "11/3");
  EXPECT_EQ(stopOfCreate("90,1", 5), "11/4");
  EXPECT_EQ(stopOfCreate("90,1", 4), "");
  EXPECT_EQ(stopOfCreate("100,100", 255), "11/5");
  EXPECT_EQ(stopOfCreate("100,1", 256), "11/6");
  EXPECT_EQ(stopOfCreate("0,1", 9), "11/7");
}

// S5-FM-09
TEST(CreateDataBlocks, FromTransferFlags) {
  Rig rig;
  ASSERT_TRUE(
      rig.start("OB 1\n:L KY 50,1\n:T MW 246\n:L KF +3\n:T MW 248\n" + create("0,0", 0) + ":BE\n"));
  rig.cycles(1);
  EXPECT_EQ(rig.machine().blocks.find({mc5::BlockType::Db, 50}).length, 4u);
}

std::string transfer(const std::string& blocks, int from, const std::string& rest) {
  return ":SPA FB 60\nNAME :BLOCK-TR\nDBQZ : KY " + blocks + "\nDWQ : KF " + std::to_string(from) +
         "\nDZ/A : KY " + rest + "\n";
}
std::string blocks() { return dataBlock(10, 20) + dataBlock(20, 150) + dataBlock(21, 150); }

void fill(Rig& rig) {
  for (unsigned i = 0; i < 20; ++i) rig.word(10, i) = static_cast<std::uint16_t>(i + 1);
}

// S5-FM-19, S5-FM-20
TEST(BlockTransfer, CopiesWords) {
  Rig rig;
  ASSERT_TRUE(rig.start(blocks() + "OB 1\n" + transfer("10,20", 5, "2,10") + ":BE\n"));
  fill(rig);
  rig.cycles(1);
  EXPECT_EQ(rig.word(20, 1), 0u);
  for (unsigned i = 0; i < 10; ++i) EXPECT_EQ(rig.word(20, 2 + i), 6 + i);
  EXPECT_EQ(rig.word(20, 12), 0u);
}

// S5-FM-19, S5-FM-22: 128 words are the most, and all of them arrive.
TEST(BlockTransfer, AHundredAndTwentyEightWords) {
  for (const unsigned count : {128u, 129u}) {
    Rig rig;
    ASSERT_TRUE(rig.start(blocks() + "OB 1\n" + transfer("20,21", 3, "1," + std::to_string(count)) +
                          ":BE\n"));
    for (unsigned i = 0; i < 150; ++i) rig.word(20, i) = static_cast<std::uint16_t>(i + 1);
    rig.cycles(1);
    EXPECT_EQ(rig.stop(), count == 128 ? "" : "60/1");
    for (unsigned i = 0; i < 150; ++i)
      EXPECT_EQ(rig.word(21, i), count == 128 && i >= 1 && i <= 128 ? i + 3 : 0u) << i;
  }
}

// S5-FM-19: a block onto itself.
TEST(BlockTransfer, OverlappingWords) {
  Rig rig;
  ASSERT_TRUE(rig.start(blocks() + "OB 1\n:UN M 100.0\n:S M 100.0\n:SPB FB 60\nNAME :BLOCK-TR\n" +
                        "DBQZ : KY 10,10\nDWQ : KF 0\nDZ/A : KY 1,10\n:BE\n"));
  fill(rig);
  rig.cycles(2);
  for (unsigned i = 0; i < 10; ++i) EXPECT_EQ(rig.word(10, 1 + i), 1 + i);
}

// S5-FM-21: 0,1 and 1,0 and 0,0 take the flags.
TEST(BlockTransfer, FromTransferFlags) {
  for (const char* const zero : {"0,0", "0,1", "1,0"}) {
    Rig rig;
    ASSERT_TRUE(rig.start(blocks() + "OB 1\n:L KY 10,20\n:T MW 250\n:L KF +5\n:T MW 252\n" +
                          ":L KY 0,10\n:T MW 254\n" + transfer(zero, 0, "0,0") + ":BE\n"));
    fill(rig);
    rig.cycles(1);
    EXPECT_EQ(rig.word(20, 9), 15u) << zero;
  }
}

// S5-FM-05, S5-FM-22
TEST(BlockTransfer, Errors) {
  const auto stopOf = [](const std::string& numbers, int from, const std::string& rest) {
    Rig rig;
    rig.options.dataInEprom.set(21);
    rig.start(blocks() + "OB 1\n" + transfer(numbers, from, rest) + ":BE\n");
    rig.cycles(1);
    return rig.stop();
  };
  EXPECT_EQ(stopOf("20,10", 0, "0,129"), "60/1");
  EXPECT_EQ(stopOf("10,20", 0, "0,0"), "60/2");
  EXPECT_EQ(stopOf("11,20", 0, "0,1"), "60/3");
  EXPECT_EQ(stopOf("10,22", 0, "0,1"), "60/4");
  EXPECT_EQ(stopOf("20,10", 0, "10,11"), "60/5");
  EXPECT_EQ(stopOf("20,10", 0, "10,10"), "");
  EXPECT_EQ(stopOf("10,21", 0, "0,1"), "60/6");
  EXPECT_EQ(stopOf("21,10", 0, "0,1"), "");  // the source may lie in the EPROM
  EXPECT_EQ(stopOf("10,20", 11, "0,10"), "60/7");
  EXPECT_EQ(stopOf("10,20", -1, "0,1"), "60/7");
}

// S5-FM-04: a conditional call without condition does nothing.
TEST(BlockTransfer, ConditionalCall) {
  Rig rig;
  ASSERT_TRUE(rig.start("OB 1\n:U M 0.0\n:SPB FB 60\nNAME :BLOCK-TR\nDBQZ : KY 1,1\nDWQ : KF 0\n" +
                        std::string("DZ/A : KY 0,0\n:BE\n")));
  rig.cycles(2);
  EXPECT_EQ(rig.stop(), "");
}

}  // namespace
}  // namespace merker::nc
