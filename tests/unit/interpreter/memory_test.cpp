// Indirect addressing and the synchronous errors of accesses (S7-IND, S7-OBI-14).
#include <gtest/gtest.h>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

// S7-IND-03, S7-IND-05, S7-IND-06
TEST(Indirect, FindsTheOperand) {
  Rig rig({{Operation::LOAD, mc7::memoryIndirect(Area::Flag, Width::Byte, Area::Flag, 2)},
           {Operation::LOAD, mc7::registerIndirect(Area::Flag, Width::Byte, 1, bitAddress(2))},
           {Operation::LOAD, mc7::registerCrossing(Width::Word, 2, bitAddress(2))},
           {Operation::AND, mc7::registerCrossing(Width::Bit, 2, bitAddress(0, 3))},
           {Operation::ASSIGN, mc7::memoryIndirect(Area::Output, Width::Bit, Area::Flag, 2)}});
  rig.start();
  cpu::Machine& m = rig.machine();
  m.areas.flag(2)[3] = 8 * 8 + 1;  // MD 2 = P#8.1
  m.areas.flag(8)[0] = 0xA5;
  rig.registers().ar1 = bitAddress(6);
  rig.registers().ar2 = pointer(Area::Flag, bitAddress(6));
  m.areas.flag(2)[3] = 8 * 8;
  rig.step();
  EXPECT_EQ(rig.accu1(), 0xA5u);
  rig.step();
  EXPECT_EQ(rig.accu1(), 0xA5u);
  rig.step();
  EXPECT_EQ(rig.accu1(), 0xA500u);
  m.areas.flag(6)[0] = 0x08;
  rig.step();
  EXPECT_TRUE(rig.status().rlo);
  m.areas.flag(2)[3] = 8 * 8 + 1;
  rig.step();
  EXPECT_EQ(*m.areas.output(8), 0x02);
}

// S7-IND-02: each area code.
TEST(Indirect, KnowsEveryArea) {
  const Area areas[] = {Area::Peripheral, Area::Input,    Area::Output, Area::Flag,
                        Area::DataBlock,  Area::Instance, Area::Local};
  for (const Area area : areas) {
    Rig rig({{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)},
             {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 2, true)},
             {Operation::LOAD, word(0xBEEF)},
             {Operation::TRANSFER, mc7::registerCrossing(Width::Word, 1, bitAddress(2))},
             {Operation::LOAD, mc7::registerCrossing(Width::Byte, 1, bitAddress(3))}},
            {dataBlock(1, 30), dataBlock(2, 30)});
    rig.start();
    rig.registers().ar1 = pointer(area, bitAddress(20));
    rig.step(4);
    if (area == Area::Peripheral) rig.machine().areas.inputs[23] = 0xEF;
    rig.step();
    EXPECT_FALSE(rig.stopped());
    EXPECT_EQ(rig.accu1(), 0xEFu) << static_cast<int>(area);
  }
}

// S7-IND-04
TEST(Indirect, Numbers) {
  Operand timer{.kind = OperandKind::TimerIndirect, .pointerArea = Area::Flag, .value = 4};
  Operand counter{.kind = OperandKind::CounterIndirect, .pointerArea = Area::Flag, .value = 4};
  Operand block{.kind = OperandKind::BlockIndirect,
                .pointerArea = Area::Flag,
                .blockKind = BlockKind::DB,
                .value = 4};
  Rig rig({{Operation::LOAD, word(0x0500)},
           {Operation::SET, {}},
           {Operation::TIMER_SV, timer},
           {Operation::SET, {}},
           {Operation::COUNT_UP, counter},
           {Operation::OPEN, block}},
          {dataBlock(7, 2)});
  rig.start();
  rig.machine().areas.flag(4)[1] = 7;
  rig.step(6);
  EXPECT_TRUE(rig.machine().timers[7].started);
  EXPECT_EQ(rig.machine().counters[7].count, 1);
  EXPECT_EQ(rig.registers().db.number, 7);
}

struct Fault {
  const char* name;
  Instruction instruction;
  std::uint32_t ar1;
  unsigned code;    // SW_FLT
  unsigned access;  // RESERVED_1
  unsigned detail;  // FLT_REG
};

const std::vector<Fault>& faults() {
  constexpr Area M = Area::Flag;
  static const std::vector<Fault> rows = {
      {"length read",
       {Operation::LOAD, mc7::registerCrossing(Width::Word, 1, 0)},
       pointer(M, bitAddress(255)),
       0x22,
       0x23,
       255},
      {"length write",
       {Operation::TRANSFER, mc7::registerCrossing(Width::DWord, 1, 0)},
       pointer(M, bitAddress(253)),
       0x23,
       0x33,
       253},
      {"length bit",
       {Operation::AND, mc7::registerCrossing(Width::Bit, 1, 0)},
       pointer(M, bitAddress(256)),
       0x22,
       0x03,
       256},
      {"area read",
       {Operation::LOAD, mc7::registerCrossing(Width::Byte, 1, 0)},
       0x99000000,
       0x24,
       0x10,
       0},
      {"area write",
       {Operation::ASSIGN, mc7::registerCrossing(Width::Bit, 1, 0)},
       0x00000008,
       0x25,
       0x00,
       1},
      {"alignment read",
       {Operation::LOAD, mc7::registerIndirect(M, Width::Word, 1, 0)},
       0x11,
       0x28,
       0x23,
       2},
      {"alignment write",
       {Operation::TRANSFER, mc7::registerIndirect(M, Width::Byte, 1, 0)},
       0x13,
       0x29,
       0x13,
       2},
      {"no block open",
       {Operation::LOAD, mc7::memory(Area::DataBlock, Width::Word, 0)},
       0,
       0x22,
       0x24,
       0},
      {"no instance",
       {Operation::TRANSFER, mc7::memory(Area::Instance, Width::Word, 0)},
       0,
       0x23,
       0x25,
       0},
      {"no caller",
       {Operation::LOAD, mc7::registerCrossing(Width::Byte, 1, 0)},
       pointer(Area::CallerLocal, 0),
       0x24,
       0x17,
       0},
      {"timer number",
       {Operation::AND, {.kind = OperandKind::Timer, .value = 300}},
       0,
       0x26,
       0x00,
       300},
      {"counter number",
       {Operation::AND, {.kind = OperandKind::Counter, .value = 300}},
       0,
       0x27,
       0x00,
       300},
      {"DB number", {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 200)}, 0, 0x32, 0x00, 200},
      {"DI number",
       {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 200, true)},
       0,
       0x33,
       0x00,
       200},
      {"FC number", {Operation::UC, mc7::blockOperand(BlockKind::FC, 200)}, 0, 0x34, 0x00, 200},
      {"FB number", {Operation::UC, mc7::blockOperand(BlockKind::FB, 200)}, 0, 0x35, 0x00, 200},
      {"DB missing", {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 99)}, 0, 0x3A, 0x00, 99},
      {"FC missing", {Operation::UC, mc7::blockOperand(BlockKind::FC, 99)}, 0, 0x3C, 0x00, 99},
      {"SFC missing", {Operation::UC, mc7::blockOperand(BlockKind::SFC, 99)}, 0, 0x3D, 0x00, 99},
      {"FB missing", {Operation::UC, mc7::blockOperand(BlockKind::FB, 99)}, 0, 0x3E, 0x00, 99},
      {"SFB missing", {Operation::UC, mc7::blockOperand(BlockKind::SFB, 99)}, 0, 0x3F, 0x00, 99},
      {"periphery read",
       {Operation::LOAD, mc7::memory(Area::Peripheral, Width::Word, bitAddress(400))},
       0,
       0x42,
       0x20,
       400},
      {"periphery write",
       {Operation::TRANSFER, mc7::memory(Area::Peripheral, Width::Byte, bitAddress(400))},
       0,
       0x43,
       0x10,
       400},
  };
  return rows;
}

// The error OB copies its start information to MB 100..119.
block::Block errorOb(std::uint16_t number) {
  std::vector<Instruction> code;
  for (std::uint32_t byte = 0; byte < 20; byte += 4) {
    code.push_back({Operation::LOAD, mc7::memory(Area::Local, Width::DWord, bitAddress(byte))});
    code.push_back(
        {Operation::TRANSFER, mc7::memory(Area::Flag, Width::DWord, bitAddress(100 + byte))});
  }
  code.push_back({Operation::BE, {}});
  return codeBlock(BlockKind::OB, number, code);
}

unsigned wordAt(Rig& rig, std::uint32_t byte) {
  const std::uint8_t* p = rig.machine().areas.flag(byte);
  return static_cast<unsigned>(p[0] << 8 | p[1]);
}

// S7-OBI-13, S7-OBI-14, S7-OBI-15, S7-ERR-02, S7-IND-07, S7-BLK-16, S7-OPEN-41
TEST(SyncErrors, CallTheErrorObWithItsStartInformation) {
  for (const Fault& row : faults()) {
    SCOPED_TRACE(row.name);
    Rig rig({{Operation::NOP0, {}},
             row.instruction,
             {Operation::SET, {}},
             {Operation::ASSIGN, flag(0, 0)}},
            {errorOb(121), errorOb(122)});
    rig.start();
    rig.registers().ar1 = row.ar1;
    rig.finish();
    ASSERT_FALSE(rig.stopped());
    const bool access = row.code >= 0x42;
    EXPECT_EQ(wordAt(rig, 100), (access ? 0x2900u : 0x2500u) | row.code);
    EXPECT_EQ(wordAt(rig, 102), 0x0100u | (access ? 122u : 121u));  // priority of OB 1, number
    EXPECT_EQ(wordAt(rig, 104), 0x8800u | row.access);
    EXPECT_EQ(wordAt(rig, 106), row.detail);
    EXPECT_EQ(wordAt(rig, 108), 1u);  // in OB 1
    EXPECT_EQ(wordAt(rig, 110), 2u);  // behind NOP 0
    EXPECT_EQ(wordAt(rig, 112), 0x9001u);
    EXPECT_EQ(*rig.machine().areas.flag(0), 1);  // goes on behind the instruction
  }
}

// S7-ERR-02, S7-DIAG-03, S7-OPND-04, S7-OPND-11
TEST(SyncErrors, WithoutErrorObTheCpuStops) {
  for (const Fault& row : faults()) {
    SCOPED_TRACE(row.name);
    Rig rig({row.instruction});
    rig.start();
    rig.registers().ar1 = row.ar1;
    rig.finish();
    EXPECT_EQ(rig.stopEvent(), row.code >= 0x42 ? 0x4563u : 0x4562u);
    EXPECT_TRUE(rig.cpu().state().stoppedByFault());
    const auto& events = rig.cpu().diagnostics().events();
    EXPECT_EQ(events[events.size() - 2].event, (row.code >= 0x42 ? 0x2900u : 0x2500u) | row.code);
  }
}

// S7-ERR-03: a faulty read delivers 0, a faulty write is suppressed.
TEST(SyncErrors, ReadZeroWriteNothing) {
  Rig rig({{Operation::LOAD, word(0x1234)},
           {Operation::LOAD, mc7::memory(Area::Peripheral, Width::Word, bitAddress(400))},
           {Operation::TRANSFER, flagWord(10)},
           {Operation::TAK, {}},
           {Operation::TRANSFER, mc7::memory(Area::DataBlock, Width::DWord, bitAddress(8))},
           {Operation::TRANSFER, flagWord(12)}},
          {errorOb(121), errorOb(122)});
  rig.start();
  rig.machine().areas.flag(10)[0] = 0xFF;
  rig.finish();
  EXPECT_EQ(wordAt(rig, 10), 0u);
  EXPECT_EQ(wordAt(rig, 12), 0x1234u);
}

// S7-OBI-14: 30 and 31, write-protected blocks.
TEST(SyncErrors, WriteProtectedBlocks) {
  for (const bool instance : {false, true}) {
    block::Block protectedDb = dataBlock(1, 10);
    protectedDb.attributes.readOnly = true;
    const Area area = instance ? Area::Instance : Area::DataBlock;
    Rig rig({{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1, instance)},
             {Operation::LOAD, word(5)},
             {Operation::TRANSFER, mc7::memory(area, Width::Word, bitAddress(2))}},
            {protectedDb, errorOb(121)});
    rig.start();
    rig.finish();
    EXPECT_EQ(wordAt(rig, 100), instance ? 0x2531u : 0x2530u);
    EXPECT_EQ(rig.machine().dataBlocks.find(1)->data[3], 0);
  }
}

// S7-ERR-04, S7-DIAG-03
TEST(SyncErrors, NestedTooDeeplyStop) {
  Rig rig(
      {{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 99)}},
      {codeBlock(BlockKind::OB, 121,
                 {{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 98)}, {Operation::BE, {}}})});
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.stopEvent(), 0x4573u);
}

// S7-OPND-07, S7-OPND-10, S7-LOAD-05: periphery reads terminals; a write inside the image changes
// the image at once.
TEST(Periphery, GoesPastTheImage) {
  Rig rig({{Operation::LOAD, mc7::memory(Area::Peripheral, Width::Byte, bitAddress(1))},
           {Operation::LOAD, mc7::memory(Area::Input, Width::Byte, bitAddress(1))},
           {Operation::LOAD, word(0xAB)},
           {Operation::TRANSFER, mc7::memory(Area::Peripheral, Width::Byte, bitAddress(1))},
           {Operation::LOAD, mc7::memory(Area::Output, Width::Byte, bitAddress(1))}});
  rig.start();
  rig.machine().areas.inputs[1] = 0x55;
  rig.step();
  EXPECT_EQ(rig.accu1(), 0x55u);
  rig.step();
  EXPECT_EQ(rig.accu1(), 0u);
  rig.step(3);
  EXPECT_EQ(rig.accu1(), 0xABu);
  EXPECT_EQ(rig.machine().areas.outputs[1], 0xAB);
}

}  // namespace
}  // namespace merker::interpreter::test
