#include <gtest/gtest.h>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

struct Bits {
  bool op, rlo, orBit, er;
};

cpu::StatusWord query(Operation operation, Bits b) {
  Rig rig({{operation, flag(10, 3)}});
  rig.start();
  *rig.machine().areas.flag(10) = b.op ? 0x08 : 0x00;
  rig.status() = {.er = b.er, .orBit = b.orBit, .rlo = b.rlo};
  rig.step();
  return rig.status();
}

template <typename Check>
void forAll(Check check) {
  for (unsigned i = 0; i < 16; ++i)
    check(Bits{(i & 1) != 0, (i & 2) != 0, (i & 4) != 0, (i & 8) != 0});
}

// S7-INSTR-02, S7-INSTR-03, S7-BIT-01, S7-BIT-04: all 16 combinations.
TEST(BitLogic, And) {
  forAll([](Bits b) {
    for (const bool negated : {false, true}) {
      const cpu::StatusWord s = query(negated ? Operation::AND_NOT : Operation::AND, b);
      EXPECT_EQ(s.rlo, ((b.rlo || !b.er) && (b.op != negated)) || (b.orBit && b.er));
      EXPECT_EQ(s.orBit, b.orBit && b.er);
      EXPECT_EQ(s.sta, b.op);
      EXPECT_TRUE(s.er);
    }
  });
}

// S7-INSTR-04, S7-INSTR-05, S7-BIT-02
TEST(BitLogic, Or) {
  forAll([](Bits b) {
    for (const bool negated : {false, true}) {
      const cpu::StatusWord s = query(negated ? Operation::OR_NOT : Operation::OR, b);
      EXPECT_EQ(s.rlo, (b.rlo && b.er) || (b.op != negated));
      EXPECT_FALSE(s.orBit);
      EXPECT_EQ(s.sta, b.op);
    }
  });
}

// S7-INSTR-06, S7-INSTR-07, S7-BIT-03
TEST(BitLogic, Xor) {
  forAll([](Bits b) {
    for (const bool negated : {false, true}) {
      const cpu::StatusWord s = query(negated ? Operation::XOR_NOT : Operation::XOR, b);
      EXPECT_EQ(s.rlo, (b.rlo && b.er) != (b.op != negated));
      EXPECT_EQ(s.sta, b.op);
    }
  });
}

// S7-BIT-08: O 0, O 1, O 0, = : VKE 0 1 1 1, STA 0 1 0 1.
TEST(BitLogic, TheExampleOfTheCourse) {
  Rig rig({{Operation::OR, flag(0, 0)},
           {Operation::OR, flag(0, 1)},
           {Operation::OR, flag(0, 2)},
           {Operation::ASSIGN, flag(1, 0)}});
  rig.start();
  *rig.machine().areas.flag(0) = 0x02;
  const bool rlo[] = {false, true, true, true}, sta[] = {false, true, false, true};
  for (int i = 0; i < 4; ++i) {
    rig.step();
    EXPECT_EQ(rig.status().rlo, rlo[i]) << i;
    EXPECT_EQ(rig.status().sta, sta[i]) << i;
  }
}

// S7-INSTR-18, S7-INSTR-19
TEST(BitLogic, Edges) {
  for (const bool rising : {true, false})
    for (const bool before : {false, true})
      for (const bool now : {false, true}) {
        Rig rig({{rising ? Operation::EDGE_POSITIVE : Operation::EDGE_NEGATIVE, flag(10, 3)}});
        rig.start();
        *rig.machine().areas.flag(10) = before ? 0x08 : 0;
        rig.status() = {.er = true, .rlo = now};
        rig.step();
        EXPECT_EQ(rig.status().rlo, rising ? now && !before : !now && before);
        EXPECT_EQ(rig.status().sta, now);
        EXPECT_EQ(*rig.machine().areas.flag(10), now ? 0x08 : 0);
      }
}

// S7-INSTR-20, S7-INSTR-21, S7-INSTR-22, S7-OPEN-50, S7-SETRESET-01, S7-SETRESET-02
TEST(BitLogic, SetResetAssign) {
  const struct {
    Operation operation;
    bool rlo, before, after, sta;
  } rows[] = {{Operation::SET_BIT, true, false, true, true},
              {Operation::SET_BIT, false, false, false, false},
              {Operation::SET_BIT, false, true, true, false},
              {Operation::RESET_BIT, true, true, false, true},
              {Operation::RESET_BIT, false, true, true, false},
              {Operation::ASSIGN, true, false, true, true},
              {Operation::ASSIGN, false, true, false, false}};
  for (const auto& row : rows) {
    Rig rig({{row.operation, flag(10, 3)}});
    rig.start();
    *rig.machine().areas.flag(10) = row.before ? 0xFF : 0xF7;
    rig.status() = {.er = true, .rlo = row.rlo};
    rig.step();
    EXPECT_EQ(*rig.machine().areas.flag(10), row.after ? 0xFF : 0xF7);
    EXPECT_EQ(rig.status().sta, row.sta);
    EXPECT_EQ(rig.status().rlo, row.rlo);
  }
}

// S7-STW-14: each query against the four combinations of A1 A0.
TEST(BitLogic, StatusBitQueries) {
  using Q = mc7::StatusQuery;
  const struct {
    Q query;
    bool at[4];  // A1A0 = 00 01 10 11
  } rows[] = {
      {Q::Equal, {true, false, false, false}},       {Q::NotEqual, {false, true, true, false}},
      {Q::Greater, {false, false, true, false}},     {Q::Less, {false, true, false, false}},
      {Q::GreaterEqual, {true, false, true, false}}, {Q::LessEqual, {true, true, false, false}},
      {Q::Unordered, {false, false, false, true}}};
  for (const auto& row : rows)
    for (unsigned code = 0; code < 4; ++code) {
      const Operand operand =
          mc7::number(OperandKind::StatusBit, static_cast<std::uint32_t>(row.query));
      EXPECT_EQ(execute({Operation::AND, operand}, {.status = code << 6}).status.rlo, row.at[code]);
    }
  const struct {
    Q query;
    std::uint32_t bit;
  } single[] = {{Q::OV, 0x20}, {Q::OS, 0x10}, {Q::BIE, 0x100}};
  for (const auto& row : single) {
    const Operand operand =
        mc7::number(OperandKind::StatusBit, static_cast<std::uint32_t>(row.query));
    EXPECT_TRUE(execute({Operation::AND, operand}, {.status = row.bit}).status.rlo);
    EXPECT_FALSE(
        execute({Operation::AND, operand}, {.status = 0x1FF & ~row.bit & ~0x9u}).status.rlo);
  }
}

// S7-INSTR-24, S7-INSTR-25
TEST(BitLogic, NotAndSave) {
  EXPECT_FALSE(execute({Operation::NOT, {}}, {.status = 2}).status.rlo);
  EXPECT_TRUE(execute({Operation::NOT, {}}, {}).status.rlo);
  EXPECT_TRUE(execute({Operation::SAVE, {}}, {.status = 2}).status.br);
  EXPECT_FALSE(execute({Operation::SAVE, {}}, {.status = 0x100}).status.br);
}

// S7-INSTR-129: = and T write 0, S and R have no effect.
TEST(MasterControlRelay, SwitchesOutputsOff) {
  for (const bool on : {true, false}) {
    Rig rig({{on ? Operation::SET : Operation::CLR, {}},
             {Operation::MCR_OPEN, {}},
             {Operation::MCRA, {}},
             {Operation::SET, {}},
             {Operation::ASSIGN, flag(0, 0)},
             {Operation::SET_BIT, flag(0, 1)},
             {Operation::RESET_BIT, flag(0, 2)},
             {Operation::LOAD, word(0x1234)},
             {Operation::TRANSFER, flagWord(2)},
             {Operation::MCR_CLOSE, {}},
             {Operation::ASSIGN, flag(1, 0)}});
    rig.start();
    *rig.machine().areas.flag(0) = 0x05;
    rig.finish();
    EXPECT_EQ(*rig.machine().areas.flag(0), on ? 0x03 : 0x04);
    EXPECT_EQ(*rig.machine().areas.flag(2), on ? 0x12 : 0x00);
    EXPECT_EQ(*rig.machine().areas.flag(1), 0x01);  // behind the zone
  }
}

// S7-INSTR-129, S7-CPU-27: nested zones, depth 8.
TEST(MasterControlRelay, InnerZonesNeedTheOuterOnes) {
  Rig rig({{Operation::CLR, {}},
           {Operation::MCR_OPEN, {}},
           {Operation::SET, {}},
           {Operation::MCR_OPEN, {}},
           {Operation::MCRA, {}},
           {Operation::SET, {}},
           {Operation::ASSIGN, flag(0, 0)},
           {Operation::MCRD, {}},
           {Operation::ASSIGN, flag(0, 1)},
           {Operation::MCR_CLOSE, {}},
           {Operation::MCR_CLOSE, {}}});
  rig.start();
  rig.finish();
  EXPECT_EQ(*rig.machine().areas.flag(0), 0x02);

  Rig deep(std::vector<Instruction>(8, {Operation::MCR_OPEN, {}}));
  deep.start();
  deep.finish();
  EXPECT_FALSE(deep.stopped());
  Rig tooDeep(std::vector<Instruction>(9, {Operation::MCR_OPEN, {}}));
  tooDeep.start();
  tooDeep.finish();
  EXPECT_EQ(tooDeep.stopEvent(), 0x4572u);
  Rig unopened({{Operation::MCR_CLOSE, {}}});
  unopened.start();
  unopened.finish();
  EXPECT_EQ(unopened.stopEvent(), 0x4572u);
}

}  // namespace
}  // namespace merker::interpreter::test
