// Instructions by their codes: displays, accumulators, blocks, traps.
#include "bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

// S5-BIT-02, S5-STAT-02, S5-STORE-06
TEST(Processor, FirstScanBeginsTheChainAndAssignmentEndsIt) {
  Bench b;
  b.machine.inputs[0] = 0x01;
  EXPECT_EQ(b.run({0xC000, 0x9805, 0x9905, 0xC900, 0x9A05}), Outcome::LevelEnded);
  EXPECT_TRUE(b.flag(5, 0));
  EXPECT_TRUE(b.flag(5, 1));
  EXPECT_FALSE(b.flag(5, 2));  // O E 0.1 is a first scan
}

// S5-BIT-07, S5-BIT-09: AND before OR, brackets, all rows of the truth tables.
TEST(Processor, BranchesAndBrackets) {
  for (unsigned in = 0; in < 16; ++in) {
    const bool a = in & 1, c = in & 2, d = in & 4, e = in & 8;
    Bench b;
    b.machine.inputs[0] = static_cast<std::uint8_t>(in);
    b.run({0xC000, 0xC100, 0xFB00, 0xC200, 0xC300, 0x9805});
    EXPECT_EQ(b.flag(5, 0), (a && c) || (d && e)) << in;
    b.run({0xBA00, 0xC800, 0xC900, 0xBF00, 0xBA00, 0xCA00, 0xCB00, 0xBF00, 0x9905});
    EXPECT_EQ(b.flag(5, 1), (a || c) && (d || e)) << in;
  }
}

struct Sum {
  unsigned left, right, code, akku;
  int anz1, anz0, ov;
};

class Arithmetic : public testing::TestWithParam<Sum> {};

// S5-STAT-05, S5-STAT-06, S5-STAT-07, S5-ARITH-02 … S5-ARITH-05, S5-NUM-11
TEST_P(Arithmetic, ResultAndDisplays) {
  const Sum& row = GetParam();
  Bench b;
  b.run({0x3004, row.left, 0x3004, row.right, row.code});
  EXPECT_EQ(b.last.akku1, row.akku);
  EXPECT_EQ(b.last.displays.anz1, row.anz1 != 0);
  EXPECT_EQ(b.last.displays.anz0, row.anz0 != 0);
  EXPECT_EQ(b.last.displays.ov, row.ov != 0);
  EXPECT_EQ(b.last.displays.os, row.ov != 0);
  EXPECT_EQ(b.last.akku2, row.left);
}

INSTANTIATE_TEST_SUITE_P(
    Table, Arithmetic,
    testing::Values(Sum{10, 3, 0x5900, 7, 1, 0, 0}, Sum{3, 10, 0x5900, 0xFFFFFFF9, 0, 1, 0},
                    Sum{3, 3, 0x5900, 0, 0, 0, 0}, Sum{0x7FFF, 1, 0x7900, 0x8000, 0, 1, 1},
                    Sum{0x8000, 0xFFFF, 0x7900, 0x7FFF, 1, 0, 1},
                    Sum{0x8000, 0x8000, 0x7900, 0, 0, 0, 1}, Sum{300, 300, 0x6004, 0x5F90, 0, 1, 1},
                    Sum{0xFED4, 300, 0x6004, 0xA070, 1, 0, 1}, Sum{7, 2, 0x6000, 0x10003, 1, 0, 0},
                    Sum{0xFFF9, 2, 0x6000, 0xFFFFFFFD, 0, 1, 0}, Sum{1, 0, 0x6000, 0, 1, 1, 1},
                    Sum{0x8000, 0xFFFF, 0x6000, 0x8000, 0, 1, 1}));

// S5-CMP-01, S5-CMP-02, S5-CMP-03: signed words, VKE and ANZ.
TEST(Processor, ComparisonOfWords) {
  Bench b;
  b.run({0x3004, 0xFFFF, 0x3004, 0x0001, 0x2140, 0x9805});  // -1 < 1
  EXPECT_TRUE(b.flag(5, 0));
  EXPECT_TRUE(b.last.displays.anz0);
  b.run({0x3004, 0xFFFF, 0x3004, 0x0001, 0x2120, 0x9805});  // -1 > 1
  EXPECT_FALSE(b.flag(5, 0));
}

// S5-SHIFT-01 … S5-SHIFT-04
TEST(Processor, Shifting) {
  Bench b;
  b.run({0x3040, 0x14AF, 0x6104});
  EXPECT_EQ(b.last.akku1, 0x4AF0u);
  b.run({0x3040, 0x8000, 0x6841});
  EXPECT_EQ(b.last.akku1, 0xF800u);
  b.run({0x3040, 0x8000, 0x6904});
  EXPECT_EQ(b.last.akku1, 0x0800u);
  b.run({0x3040, 0x0001, 0x2920});
  EXPECT_EQ(b.last.akku1, 0u);
  EXPECT_TRUE(b.last.displays.anz1);
  b.run({0x3800, 0x8000, 0x0000, 0x7120});
  EXPECT_EQ(b.last.akku1, 0xFFFFFFFFu);
  b.run({0x3040, 0x8001, 0x6100});
  EXPECT_EQ(b.last.akku1, 0x8001u);
}

// S5-CONV-01 … S5-CONV-07
TEST(Processor, Conversions) {
  Bench b;
  const auto akku = [&](std::initializer_list<unsigned> code) {
    b.run(code);
    return b.last.akku1;
  };
  EXPECT_EQ(akku({0x3040, 0x3E5B, 0x0100}), 0xC1A4u);              // KEW
  EXPECT_EQ(akku({0x3040, 0x0033, 0x0900}), 0xFFCDu);              // KZW
  EXPECT_EQ(akku({0x3040, 0x0001, 0x6807}), 0xFFFFFFFFu);          // KZD
  EXPECT_EQ(akku({0x3040, 0xF012, 0x680C}), 0xFFF4u);              // DEF
  EXPECT_EQ(akku({0x3004, 0xFFF4, 0x6808}), 0xF012u);              // DUF
  EXPECT_EQ(akku({0x3800, 0xF000, 0x0012, 0x680E}), 0xFFFFFFF4u);  // DED
  EXPECT_EQ(akku({0x2801, 0x6806}), 0x01400000u);                  // FDG
  EXPECT_EQ(akku({0x3800, 0x025C, 0xCCCD, 0x6002}), 2u);           // GFD 2.9
  EXPECT_EQ(akku({0x3040, 0x00A5, 0x680C}), 0x00A5u);              // no BCD
  EXPECT_TRUE(b.last.displays.ov);
  EXPECT_EQ(akku({0x3004, 1000, 0x6808}), 1000u);
  EXPECT_TRUE(b.last.displays.os);
  EXPECT_EQ(akku({0x3040, 0x8000, 0x0900}), 0x8000u);
  EXPECT_TRUE(b.last.displays.ov);
}

// S5-BLK-13, S5-BLK-16, S5-BLK-17, S5-CALL-02, S5-JUMP-01: VKE goes into the block, conditions
// leave 1.
TEST(Processor, CallsAndConditions) {
  Bench b;
  b.block(BlockType::Pb, 1, {0x980A, 0x6500});
  b.machine.inputs[0] = 1;
  b.run({0xC000, 0x7501, 0xC100, 0x990A});
  EXPECT_TRUE(b.flag(10, 0));
  EXPECT_FALSE(b.flag(10, 1));
  b.run({0xC100, 0x5501, 0x9A0A});  // U E 0.1 / SPB PB 1 / = M 10.2
  EXPECT_TRUE(b.flag(10, 2));
}

// S5-BLK-07, S5-BLK-18, S5-DB-13, S5-DB-14, S5-OPC-03, S5-MISC-02, S5-COUNTER-09, S5-MD-02
TEST(Processor, Traps) {
  const auto alarmOf = [](std::initializer_list<unsigned> code) {
    Bench b;
    EXPECT_EQ(b.run(code), Outcome::Trapped);
    return b.processor.trap().alarm;
  };
  EXPECT_EQ(alarmOf({0x75C8}), Alarm::MissingBlock);
  EXPECT_EQ(alarmOf({0x204D}), Alarm::MissingDb);
  EXPECT_EQ(alarmOf({0x3300}), Alarm::TransferToMissingDb);
  EXPECT_EQ(alarmOf({0x0800}), Alarm::IllegalCode);
  EXPECT_EQ(alarmOf({0x527F}), Alarm::IllegalParameter);
  EXPECT_EQ(alarmOf({0x7000}), Alarm::Sts);
  EXPECT_EQ(alarmOf({0x6C28}), Alarm::TimerCounter);
  EXPECT_EQ(alarmOf({0x2410}), Alarm::TimerCounter);  // T 16 with MD 6 = 15
  EXPECT_EQ(alarmOf({0x7264}), Alarm::NoAnswerPeriphery);
  EXPECT_EQ(alarmOf({0x4000}), Alarm::SystemCommandsLocked);
}

TEST(Processor, TheThirteenthBlockIsTooDeep) {
  Bench b;
  for (unsigned pb = 1; pb <= 11; ++pb)
    b.block(BlockType::Pb, static_cast<std::uint16_t>(pb),
            {pb < 11 ? 0x7500 + pb + 1 : 0x0000, 0x6500});
  EXPECT_EQ(b.run({0x7501}), Outcome::LevelEnded);
  b.block(BlockType::Pb, 11, {0x750C, 0x6500});
  b.block(BlockType::Pb, 12, {0x6500});
  EXPECT_EQ(b.runOb(), Outcome::Trapped);
  EXPECT_EQ(b.processor.trap().alarm, Alarm::BlockStack);
  EXPECT_EQ(b.machine.level().frames.size(), kNesting);
}

// S5-DB-06, S5-DB-07, S5-DB-08: the caller's data block comes back, the called block inherits it.
TEST(Processor, OpenDataBlockBelongsToItsBlock) {
  Bench b;
  b.block(BlockType::Db, 10, {0x1111});
  b.block(BlockType::Db, 11, {0x2222});
  b.block(BlockType::Pb, 20, {0x3200, 0x1314, 0x200B, 0x3200, 0x1316, 0x6500});
  b.run({0x200A, 0x7514, 0x3200, 0x1318});
  EXPECT_EQ(b.flagWord(20), 0x1111u);
  EXPECT_EQ(b.flagWord(22), 0x2222u);
  EXPECT_EQ(b.flagWord(24), 0x1111u);
}

// S5-OPC-04: printed times, the shorter one where nothing is done.
TEST(Processor, ChargesThePrintedTimes) {
  Bench b;
  b.run({0x2801, 0x2801});
  EXPECT_EQ(b.machine.clock.ns, 2 * 250 + 22'800);  // ACOP: 2 x L KB, BE
  b.environment.variant = mc5::Variant::Cop;
  b.machine.clock = {};
  b.run({0x2801, 0x5501});  // L KB 1, SPB PB 1 not taken
  EXPECT_EQ(b.machine.clock.ns, 4'400 + 300 + 22'800);
}

}  // namespace
}  // namespace merker::sinumerik
