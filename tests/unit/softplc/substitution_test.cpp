// Formal operands, B DW and B MW (9.4.1 to 9.4.6, 9.4.12).
#include "bench.h"

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

// The manual's FB 203: ANNA = E 10.3, BERT = T 17, HANS = A 18.4 (S5-FB-03, S5-SUBST-03).
TEST(Formal, ManualExampleFb203) {
  Bench b;
  b.environment.lastTimer = 31;
  b.block(BlockType::Fb, 203, {0x0701, 0x3002, 0x2010, 0x2E02, 0x0702, 0x1F03, 0x6500});
  b.machine.inputs[10] = 0x08;
  b.run({0x3DCB, 0x2D04, 0xC30A, 0x0211, 0xC492});
  EXPECT_EQ(b.machine.timers[17].value(), 10u);
  EXPECT_EQ(b.machine.outputs[18], 0u);
  b.machine.clock = Instant{} + Duration::seconds(11);
  b.machine.timers[17].count(b.machine.clock, b.environment.timeBases);
  b.runOb();
  EXPECT_EQ(b.machine.outputs[18], 0x10u);
}

// S5-FB-17, S5-SUBST-05: LW takes the word as it is; LD two words.
TEST(Formal, RawWords) {
  Bench b;
  b.block(BlockType::Fb, 1, {0x3F01, 0x130A, 0x4602, 0x130C, 0x5603, 0x1B0E, 0x6500});
  b.block(BlockType::Db, 10, {0, 0x55AA});
  b.run({0x200A, 0x3D01, 0x2D05, 0x204D, 0x3201, 0x0140, 0x0000});
  EXPECT_EQ(b.flagWord(10), 0x204Du);
  EXPECT_EQ(b.flagWord(12), 0x55AAu);
  EXPECT_EQ(b.flagWord(14), 0x0140u);
}

// S5-SUBST-06: B =X opens a data block or calls a block.
TEST(Formal, BlockParameters) {
  Bench b;
  b.block(BlockType::Fb, 1, {0x7601, 0x3200, 0x130A, 0x7602, 0x6500});
  b.block(BlockType::Db, 10, {0x1234});
  b.block(BlockType::Pb, 3, {0x2807, 0x0B0C, 0x6500});
  b.run({0x3D01, 0x2D03, 0x200A, 0x7503});
  EXPECT_EQ(b.flagWord(10), 0x1234u);
  EXPECT_EQ(b.machine.flags[12], 7u);
}

// S5-SUBST-08, S5-FB-15
TEST(Formal, AnActualOperandOfTheWrongKindStops) {
  for (const unsigned word : {0x220Fu, 0x0800u, 0x7503u}) {
    Bench b;
    b.block(BlockType::Fb, 1, {0x0701, 0x6500});
    EXPECT_EQ(b.run({0x3D01, 0x2D02, word}), Outcome::Trapped);
    EXPECT_EQ(b.processor.trap().alarm, Alarm::Substitution);
    EXPECT_EQ(b.processor.trap().words[0], 0x0701u);
  }
}

// S5-PROC-01 … -05
TEST(Process, ParameterFromFlagAndDataWords) {
  Bench b;
  b.block(BlockType::Db, 10, std::initializer_list<unsigned>{0, 0, 0, 0, 0, 0xBEEF, 0x0408});
  b.block(BlockType::Fb, 1, {0x200A, 0x4EFA, 0x3200, 0x1314, 0x6500});  // B MW 250, L DW 0
  b.machine.flags[251] = 5;
  b.run({0x3D01, 0x2D01});
  EXPECT_EQ(b.flagWord(20), 0xBEEFu);
  b.block(BlockType::Fb, 1, {0x4EFA, 0x7038, 0x4704, 0x6500});  // B MW 250, SU E 4.7
  b.machine.flags[250] = 0x01;
  b.machine.flags[251] = 0x04;
  b.runOb();
  EXPECT_EQ(b.machine.inputs[4], 0x02u);
  b.machine.flags[251] = 0x84;
  b.runOb();
  EXPECT_EQ(b.machine.outputs[4], 0x02u);
}

// S5-PROC-06
TEST(Process, WhatCannotFollow) {
  Bench b;
  b.block(BlockType::Fb, 1, {0x4EF0, 0x6500});
  b.run({0x3D01, 0x2D01});
  EXPECT_EQ(b.processor.trap().alarm, Alarm::Substitution);
  b.block(BlockType::Fb, 1, {0x4EF0, 0x4E00, 0x6500});
  b.runOb();
  EXPECT_EQ(b.processor.trap().alarm, Alarm::Substitution);
  b.block(BlockType::Fb, 1, {0x4EF0, 0x527E, 0x6500});  // L EW 126 with 127
  b.machine.flags[241] = 127;
  b.runOb();
  EXPECT_EQ(b.processor.trap().alarm, Alarm::IllegalParameter);
}

// S5-OPC-05: the times add up.
TEST(Process, TimesAdd) {
  Bench b;
  b.block(BlockType::Fb, 1, {0x4EF0, 0x0A00, 0x6500});
  b.run({0x3D01, 0x2D01});
  EXPECT_EQ(b.machine.clock.ns, 2'000 + 320 + 800 + 500 + 2 * 22'800);
}

}  // namespace
}  // namespace merker::sinumerik
