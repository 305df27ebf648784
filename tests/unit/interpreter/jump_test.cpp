#include <gtest/gtest.h>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

// Whether a jump at the start of OB 1 is taken in a state; the state behind it in `after`.
bool taken(Operation operation, std::uint32_t status, cpu::StatusWord* after = nullptr) {
  Rig rig({{operation, jump(3)}, {Operation::NOP0, {}}, {Operation::NOP1, {}}});
  rig.start();
  rig.status() = cpu::StatusWord::fromWord(status);
  rig.step();
  if (after != nullptr) *after = rig.status();
  return rig.machine().top->resume == 2;
}

// S7-INSTR-112 … -119
TEST(Jump, OnStatusBits) {
  const struct {
    Operation operation;
    std::uint32_t bit;
    bool wanted;
  } rows[] = {{Operation::SPB, 0x002, true},  {Operation::SPBN, 0x002, false},
              {Operation::SPBB, 0x002, true}, {Operation::SPBNB, 0x002, false},
              {Operation::SPBI, 0x100, true}, {Operation::SPBIN, 0x100, false},
              {Operation::SPO, 0x020, true},  {Operation::SPS, 0x010, true}};
  for (const auto& row : rows) {
    EXPECT_EQ(taken(row.operation, row.bit), row.wanted) << mc7::info(row.operation).de;
    EXPECT_EQ(taken(row.operation, 0x1FF & ~row.bit), !row.wanted) << mc7::info(row.operation).de;
  }
  EXPECT_TRUE(taken(Operation::SPA, 0));
}

// S7-INSTR-115, S7-INSTR-116: BIE copied also without jump. S7-INSTR-119: SPS takes OS back.
TEST(Jump, SideEffects) {
  cpu::StatusWord after;
  EXPECT_FALSE(taken(Operation::SPBB, 0x100, &after));
  EXPECT_FALSE(after.br);
  EXPECT_FALSE(taken(Operation::SPBNB, 0x002, &after));
  EXPECT_TRUE(after.br);
  EXPECT_TRUE(taken(Operation::SPS, 0x010, &after));
  EXPECT_FALSE(after.os);
  EXPECT_FALSE(taken(Operation::SPB, 0, &after));
  EXPECT_TRUE(after.rlo);
}

// S7-INSTR-120 … -126, S7-OPEN-02, S7-OPEN-03: four combinations of A1 A0.
TEST(Jump, OnConditionCodes) {
  const struct {
    Operation operation;
    bool at[4];  // 00 01 10 11
  } rows[] = {
      {Operation::SPZ, {true, false, false, false}}, {Operation::SPM, {false, true, false, false}},
      {Operation::SPP, {false, false, true, false}}, {Operation::SPU, {false, false, false, true}},
      {Operation::SPN, {false, true, true, false}},  {Operation::SPMZ, {true, true, false, false}},
      {Operation::SPPZ, {true, false, true, false}}};
  for (const auto& row : rows)
    for (std::uint32_t code = 0; code < 4; ++code)
      EXPECT_EQ(taken(row.operation, code << 6), row.at[code])
          << mc7::info(row.operation).de << code;
}

// S7-INSTR-127
TEST(Jump, Distributor) {
  const struct {
    std::uint32_t accu;
    std::uint32_t expected;
  } rows[] = {{0, 1}, {1, 2}, {0x102, 3}, {3, 4}, {255, 4}};
  for (const auto& row : rows) {
    Rig rig({{Operation::SPL, mc7::number(OperandKind::JumpList, 3)},
             {Operation::SPA, jump(6)},
             {Operation::SPA, jump(4)},
             {Operation::SPA, jump(2)},
             {Operation::NOP0, {}}});
    rig.start();
    rig.registers().accu[0] = row.accu;
    rig.step();
    EXPECT_EQ(rig.machine().top->resume, row.expected) << row.accu;
  }
}

// S7-INSTR-128: sum 1..5; the high word stays; 0 runs 65536 times.
TEST(Jump, Loop) {
  Rig rig({{Operation::LOAD, word(5)},
           {Operation::TRANSFER, flagWord(0)},
           {Operation::LOAD, flagWord(2)},
           {Operation::ADD_I, {}},
           {Operation::TRANSFER, flagWord(2)},
           {Operation::LOAD, flagWord(0)},
           {Operation::LOOP, jump(-5)}});
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.machine().areas.flag(2)[1], 15);

  Rig wrap({{Operation::LOOP, jump(0)}});
  wrap.start();
  wrap.registers().accu[0] = 0x00050000;
  wrap.step();
  EXPECT_EQ(wrap.accu1(), 0x0005FFFFu);
  EXPECT_EQ(wrap.machine().top->resume, 0u);
}

// S7-DIAG-03: into the middle of an instruction, out of the block, into a parameter list.
TEST(Jump, ToNowhereStops) {
  for (const std::int32_t words : {-1, 3, 6, 1000, -1000}) {
    Rig rig({{Operation::SPA, jump(words)}, {Operation::LOAD, word(5)}});
    rig.start();
    rig.finish();
    EXPECT_EQ(rig.stopEvent(), 0x4578u) << words;
  }
}

TEST(EndOfCode, WithoutBeStops) {
  block::Block fc = codeBlock(BlockKind::FC, 1, {{Operation::NOP0, {}}});
  Rig rig({{Operation::UC, mc7::blockOperand(BlockKind::FC, 1)}, {Operation::SPA, jump(2)}}, {fc});
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.stopEvent(), 0x457Au);
}

// The entry says where: at the end of the code, or at the word that is no instruction.
TEST(EndOfCode, TheEntryNamesThePlace) {
  for (const bool unknown : {false, true}) {
    block::Block fc = codeBlock(BlockKind::FC, 1, {{Operation::NOP0, {}}, {Operation::NOP0, {}}});
    if (unknown) fc.code.insert(fc.code.begin() + 2, {0x70, 0xFF});
    Rig rig({{Operation::UC, mc7::blockOperand(BlockKind::FC, 1)}}, {fc});
    rig.start();
    rig.finish();
    EXPECT_TRUE(rig.stopped());
    const cpu::Place place = rig.cpu().state().stopEvent().place;
    EXPECT_EQ(toString(place.block), "FC 1");
    EXPECT_EQ(place.offset, unknown ? 2u : 4u);
  }
}

}  // namespace
}  // namespace merker::interpreter::test
