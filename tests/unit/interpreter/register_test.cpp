// Loads, accumulators, address registers, data block registers, status word.
#include <gtest/gtest.h>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

using Accus = std::array<std::uint32_t, 4>;

// S7-INSTR-38, S7-LOAD-03, S7-LOAD-08
TEST(Load, MovesAccumulatorOneUp) {
  const cpu::Registers r = execute({Operation::LOAD, word(0xD0A5)}, {{0x12345678, 9}, 0x1FF});
  EXPECT_EQ(r.accu, (Accus{0x0000D0A5, 0x12345678, 0, 0}));
  EXPECT_EQ(r.status.word(), 0x1FF);
}

// S7-LOAD-04, S7-ADDR-04 … -07, S7-OPND-02, S7-BLK-24
TEST(Load, BytesAreBigEndian) {
  Rig rig({{Operation::LOAD, doubleWord(0x11223344)},
           {Operation::TRANSFER, mc7::memory(Area::Flag, Width::DWord, bitAddress(7))},
           {Operation::LOAD, mc7::memory(Area::Flag, Width::Word, bitAddress(8))},
           {Operation::LOAD, mc7::memory(Area::Flag, Width::Byte, bitAddress(10))}});
  rig.start();
  rig.step(3);
  EXPECT_EQ(rig.accu1(), 0x2233u);
  rig.step();
  EXPECT_EQ(rig.accu1(), 0x44u);
}

// S7-INSTR-85 … -91
TEST(Accumulators, SwapsAndSteps) {
  const struct {
    Instruction instruction;
    Accus after;
  } rows[] = {{{Operation::SWAP_BYTES_W, {}}, {0x12347856, 2, 0, 0}},
              {{Operation::SWAP_BYTES_D, {}}, {0x78563412, 2, 0, 0}},
              {{Operation::TAK, {}}, {2, 0x12345678, 0, 0}},
              {{Operation::PUSH, {}}, {0x12345678, 0x12345678, 0, 0}},
              {{Operation::POP, {}}, {2, 2, 0, 0}},
              {{Operation::INC, shiftBy(0x90)}, {0x12345608, 2, 0, 0}},
              {{Operation::DEC, shiftBy(0x79)}, {0x123456FF, 2, 0, 0}},
              {{Operation::BLD, shiftBy(130)}, {0x12345678, 2, 0, 0}},
              {{Operation::NOP0, {}}, {0x12345678, 2, 0, 0}},
              {{Operation::NOP1, {}}, {0x12345678, 2, 0, 0}}};
  for (const auto& row : rows)
    EXPECT_EQ(execute(row.instruction, {{0x12345678, 2}, 0}).accu, row.after)
        << mc7::info(row.instruction.operation).de;
}

// S7-INSTR-87 … -89 with four accumulators; S7-OPEN-12: a CPU with two does not know ENT and LEAVE.
TEST(Accumulators, FourOfThem) {
  const CpuModel& four = *findCpuModel("generic-4");
  const State before{{1, 2, 3, 4}, 0};
  EXPECT_EQ(execute({Operation::PUSH, {}}, before, four).accu, (Accus{1, 1, 2, 3}));
  EXPECT_EQ(execute({Operation::POP, {}}, before, four).accu, (Accus{2, 3, 4, 4}));
  EXPECT_EQ(execute({Operation::ENT, {}}, before, four).accu, (Accus{1, 2, 2, 3}));
  EXPECT_EQ(execute({Operation::LEAVE, {}}, before, four).accu, (Accus{1, 3, 4, 4}));
  Rig rig({{Operation::ENT, {}}});
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.stopEvent(), 0x4578u);
}

// S7-INSTR-41 … -44
TEST(AddressRegisters, LoadTransferAdd) {
  const Operand pointer = mc7::constant(ConstantFormat::Pointer, 0x83000057);  // P#M10.7
  Rig rig({{Operation::LAR1, pointer},
           {Operation::ADD_AR1, mc7::number(OperandKind::Pointer, 1)},
           {Operation::LAR2, mc7::constant(ConstantFormat::Pointer, 0x10)},
           {Operation::TAR, {}},
           {Operation::TAR2, {}},
           {Operation::TAR1, mc7::memory(Area::Flag, Width::DWord, bitAddress(20))},
           {Operation::LAR2, mc7::memory(Area::Flag, Width::DWord, bitAddress(20))},
           {Operation::LOAD, word(0xFFF8)},
           {Operation::ADD_AR1, {}}});
  rig.start();
  rig.step(2);
  EXPECT_EQ(rig.registers().ar1, 0x83000058u);
  rig.step(2);
  EXPECT_EQ(rig.registers().ar1, 0x10u);
  EXPECT_EQ(rig.registers().ar2, 0x83000058u);
  rig.step();
  EXPECT_EQ(rig.accu1(), 0x83000058u);
  rig.step(2);
  EXPECT_EQ(rig.registers().ar2, 0x10u);
  rig.step(2);
  EXPECT_EQ(rig.registers().ar1, 0x8u);
}

// S7-INSTR-44: the area stays.
TEST(AddressRegisters, AddingKeepsTheArea) {
  Rig rig({{Operation::LOAD, word(0x8000)}, {Operation::ADD_AR1, {}}});
  rig.start();
  rig.registers().ar1 = 0x83000000;
  rig.step(2);
  EXPECT_EQ(rig.registers().ar1, 0x83FF8000u);
}

// S7-INSTR-45, S7-INSTR-46, S7-STW-01
TEST(StatusWord, LoadAndTransfer) {
  EXPECT_EQ(
      execute({Operation::LOAD_STW, mc7::number(OperandKind::StatusWord, 0)}, {{}, 0x1FF}).accu[0],
      0x1F2u);
  EXPECT_EQ(execute({Operation::LOAD_STW, mc7::number(OperandKind::StatusWord, 0)}, {{}, 0x1FF},
                    *findCpuModel("generic-4"))
                .accu[0],
            0x1FFu);
  EXPECT_EQ(
      execute({Operation::TRANSFER_STW, mc7::number(OperandKind::StatusWord, 0)}, {{0xFFFFFEA5}, 0})
          .status.word(),
      0x0A5);
}

// S7-INSTR-47 … -50, S7-REG-04
TEST(DataBlockRegisters, OpenSwapAsk) {
  const auto info = [](mc7::DataBlockQuery query) {
    return Instruction{Operation::LOAD,
                       mc7::number(OperandKind::DataBlockInfo, static_cast<std::uint32_t>(query))};
  };
  Rig rig({{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)},
           {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 2, true)},
           {Operation::SWAP_DB, {}},
           info(mc7::DataBlockQuery::DbNumber),
           info(mc7::DataBlockQuery::DiNumber),
           info(mc7::DataBlockQuery::DbLength),
           info(mc7::DataBlockQuery::DiLength),
           {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 0)},
           info(mc7::DataBlockQuery::DbNumber)},
          {dataBlock(1, 20), dataBlock(2, 6)});
  rig.start();
  rig.step(3);
  const std::uint32_t expected[] = {2, 1, 6, 20};
  for (const std::uint32_t value : expected) {
    rig.step();
    EXPECT_EQ(rig.accu1(), value);
  }
  rig.step(2);
  EXPECT_EQ(rig.accu1(), 0u);
}

// S7-REG-06, S7-OPEN-51
TEST(Registers, AreZeroAtTheStartOfAnOb) {
  Rig rig({{Operation::LOAD, word(5)}, {Operation::LOAD, word(6)}, {Operation::SET, {}}});
  rig.start();
  rig.finish();
  const std::uint64_t before = rig.cpu().cycle().count();
  while (rig.cpu().cycle().count() == before && rig.cpu().betweenCycles())
    rig.cpu().step(Instant::never());
  EXPECT_EQ(rig.registers(), cpu::Registers{});
}

}  // namespace
}  // namespace merker::interpreter::test
