// LIR, TIR, TNB, TNW (9.4.13, S5-SYS).
#include "bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

struct SystemBench : Bench {
  SystemBench() {
    environment.systemCommands = true;
    block(BlockType::Db, 10, {0x1111, 0x2222, 0x3333, 0x4444, 0, 0, 0, 0});
  }
  // L KG … as 32 bits: segment and offset of a word of DB 10.
  static unsigned offset(unsigned word) { return (5 + word) * 2; }
};

// S5-SYS-02, S5-SYS-03, S5-SYS-08
TEST(System, LoadAndTransferOfWords) {
  SystemBench b;
  b.run({0x3800, 6, SystemBench::offset(1), 0x4000});
  EXPECT_EQ(b.last.akku1, 0x00002222u);
  b.run({0x3040, 0xFFFF, 0x3800, 6, SystemBench::offset(4), 0x4802});
  EXPECT_EQ(b.machine.blocks.data()[9], 0xFFFFu);
}

// S5-SYS-05, S5-SYS-06 (OP-44): both addresses are ends.
TEST(System, BlockTransfersGoDownwards) {
  SystemBench b;
  b.run({0x3800, 6, SystemBench::offset(3), 0x3800, 6, SystemBench::offset(7), 0x4303});
  const auto* words = &b.machine.blocks.data()[5];
  EXPECT_EQ(words[4], 0u);
  EXPECT_EQ(words[5], 0x2222u);
  EXPECT_EQ(words[6], 0x3333u);
  EXPECT_EQ(words[7], 0x4444u);
  b.run({0x3800, 6, SystemBench::offset(1), 0x3800, 6, SystemBench::offset(4) + 1, 0x0303});
  EXPECT_EQ(words[3], 0x4411u);
  EXPECT_EQ(words[4], 0x1122u);
}

// S5-SYS-04, S5-SYS-07
TEST(System, SegmentsAndMissingMemory) {
  const auto trapOf = [](std::initializer_list<unsigned> code) {
    SystemBench b;
    EXPECT_EQ(b.run(code), Outcome::Trapped);
    return b.processor.trap();
  };
  EXPECT_EQ(trapOf({0x3800, 7, 0, 0x4802}).alarm, Alarm::SegmentLirTir);
  EXPECT_EQ(trapOf({0x3800, 11, 0, 0x4000}).alarm, Alarm::SegmentLirTir);
  EXPECT_EQ(trapOf({0x3800, 6, 0, 0x3800, 8, 0, 0x4301}).alarm, Alarm::SegmentBlockTransfer);
  const Trap missing = trapOf({0x3800, 6, 0xF000, 0x4000});
  EXPECT_EQ(missing.alarm, Alarm::NoAnswerLirTir);
  EXPECT_EQ(missing.words[1], 0xF000u);
  EXPECT_EQ(missing.words[2], 6u);
}

}  // namespace
}  // namespace merker::sinumerik
