// What becomes of instructions in the intermediate code.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "translate/translate.h"

namespace merker::translate {
namespace {

using icode::Opcode;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

std::vector<icode::Region> regionsOf(const std::vector<mc7::Instruction>& instructions) {
  std::vector<std::uint8_t> code;
  for (const mc7::Instruction& i : instructions) EXPECT_TRUE(mc7::encode(i, code));
  auto regions = translate(mc7::list(code), defaultCpuModel());
  for (icode::Region& region : regions) {
    EXPECT_EQ(icode::verify(region), "") << icode::print(region);
    icode::optimise(region);
  }
  return regions;
}

std::size_t count(const icode::Region& region, Opcode code) {
  return static_cast<std::size_t>(
      std::count_if(region.ops.begin(), region.ops.end(),
                    [&](auto& op) { return op.needed && op.code == code; }));
}

Operand bit(Area area, std::uint32_t byte, std::uint32_t bit) {
  return mc7::memory(area, Width::Bit, bitAddress(byte, bit));
}
Operand word(std::uint32_t byte) { return mc7::memory(Area::Flag, Width::Word, bitAddress(byte)); }
const mc7::Instruction kAddInt{Operation::ADD_I, {}}, kEnd{Operation::BE, {}};

TEST(Region, AByteIsLoadedOnceAndWrittenOnce) {
  const auto regions = regionsOf({{Operation::AND, bit(Area::Input, 4, 0)},
                                  {Operation::AND, bit(Area::Input, 4, 1)},
                                  {Operation::ASSIGN, bit(Area::Output, 4, 0)},
                                  {Operation::AND, bit(Area::Input, 4, 2)},
                                  {Operation::ASSIGN, bit(Area::Output, 4, 1)},
                                  kEnd});
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Load8), 2u);
  EXPECT_EQ(count(regions[0], Opcode::Store8), 0u);
  EXPECT_EQ(regions[0].exits.back().bytes, 1u);
}

TEST(Region, FirstChecksAreKnown) {
  const auto regions = regionsOf({{Operation::SET, {}},
                                  {Operation::AND, bit(Area::Input, 4, 1)},
                                  {Operation::ASSIGN, bit(Area::Output, 4, 0)},
                                  kEnd});
  EXPECT_EQ(count(regions[0], Opcode::Get), 0u);
  EXPECT_EQ(count(regions[0], Opcode::AndBit), 0u);
}

TEST(Region, FlagsNobodyReadsVanish) {
  const auto one = regionsOf({kAddInt, kEnd}), three = regionsOf({kAddInt, kAddInt, kAddInt, kEnd});
  EXPECT_EQ(count(one[0], Opcode::Less), 2u);
  EXPECT_EQ(count(three[0], Opcode::Less), 2u);
}

TEST(Region, EndsInFrontOfWhatHasNoTranslation) {
  const auto regions = regionsOf(
      {{Operation::LOAD, word(10)}, {Operation::SIN, {}}, {Operation::TRANSFER, word(12)}, kEnd});
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].exits.back().to, 1u);
  EXPECT_EQ(regions[1].first, 2u);
}

TEST(Region, ClockOfEachExit) {
  const auto regions = regionsOf({{Operation::LOAD, word(10)}, kAddInt, kEnd});
  const CpuModel& model = defaultCpuModel();
  const auto ahead = model.wordTime + model.fixedTime;
  EXPECT_EQ(regions[0].ahead, ahead);
  EXPECT_EQ(regions[0].exits.back().cost, ahead + model.time(mc7::info(Operation::BE).time));
  EXPECT_EQ(regions[0].exits.back().instructions, 3u);
}

TEST(Region, ACallEndsIt) {
  const mc7::Instruction call{Operation::UC, mc7::blockOperand(BlockKind::FC, 7)};
  const auto regions = regionsOf({{Operation::LOAD, word(10)}, call, kAddInt, kEnd});
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].ops.back().code, Opcode::Call);
  EXPECT_EQ(regions[0].calls.back().resume, 2u);
  EXPECT_EQ(regions[1].first, 2u);
  EXPECT_EQ(regions[1].ops.back().code, Opcode::Return);
}

// CALL ends with one.
TEST(Region, AJumpToTheNextInstructionIsNoWayOut) {
  Operand next{.kind = OperandKind::Jump, .value = 2};
  const auto regions = regionsOf({{Operation::SPBI, next}, kAddInt, kEnd});
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(count(regions[0], Opcode::BranchIf), 0u);
}

TEST(Region, OpenChecksForAllReadsAndWritesBehindIt) {
  const auto data = [](std::uint32_t byte) {
    return mc7::memory(Area::DataBlock, Width::Word, bitAddress(byte));
  };
  const auto regions = regionsOf({{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 5)},
                                  {Operation::LOAD, data(0)},
                                  {Operation::LOAD, data(2)},
                                  {Operation::TRANSFER, data(4)},
                                  {Operation::TRANSFER, data(6)},
                                  kEnd});
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Guard), 0u);
  const auto open = std::find_if(regions[0].ops.begin(), regions[0].ops.end(),
                                 [](const icode::Op& op) { return op.code == Opcode::Open; });
  ASSERT_NE(open, regions[0].ops.end());
  EXPECT_EQ(icode::Opening::of(open->place).bytes, 8u);
  EXPECT_TRUE(icode::Opening::of(open->place).write);
}

TEST(Region, OneRegisterIsCheckedOnce) {
  const auto indirect = [](std::uint32_t byte) {
    return Operand{.kind = OperandKind::RegisterIndirect,
                   .area = Area::Flag,
                   .width = Width::Word,
                   .reg = 1,
                   .value = bitAddress(byte)};
  };
  const auto regions =
      regionsOf({{Operation::LOAD, indirect(0)}, {Operation::LOAD, indirect(8)}, kAddInt, kEnd});
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Guard), 2u);  // whole byte, and inside
}

// Four ways out need them; only these compute them.
TEST(Region, ConditionCodesAreLeftToTheWaysOut) {
  const auto regions = regionsOf({{Operation::ADD_R, {}}, {Operation::ADD_R, {}}, kEnd});
  const auto late = std::count_if(regions[0].ops.begin(), regions[0].ops.end(),
                                  [](const icode::Op& op) { return op.late; });
  EXPECT_EQ(late, static_cast<std::ptrdiff_t>(count(regions[0], Opcode::LessReal)));
  EXPECT_EQ(late, 4);
}

TEST(Region, AnyBytesGiveValidRegions) {
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> code(random() % 200);
    for (std::uint8_t& byte : code)
      byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    std::uint32_t end = 0;
    for (const icode::Region& region : translate(mc7::list(code), defaultCpuModel())) {
      ASSERT_EQ(icode::verify(region), "") << icode::print(region);
      ASSERT_GE(region.first, end);
      end = region.first + region.instructions;
    }
  }
}

mc7::Instruction openBlock(std::uint32_t number, bool instance) {
  return {Operation::OPEN, mc7::blockOperand(BlockKind::DB, number, instance)};
}
const mc7::Instruction kExchange{Operation::SWAP_DB, {}};

// As two calls of an FB one behind the other leave them.
TEST(Region, TwoExchangesOfTheDataBlockRegistersAreNone) {
  const auto regions = regionsOf({kExchange, kExchange, openBlock(1, true), kEnd});
  EXPECT_EQ(count(regions[0], Opcode::SwapBlocks), 0u);
  for (const icode::Exit& exit : regions[0].exits) EXPECT_FALSE(exit.swapped);
}

TEST(Region, AnExchangeWaitsForTheWayOut) {
  const auto regions = regionsOf(
      {kExchange, {Operation::LOAD, mc7::memory(Area::DataBlock, Width::Word, bitAddress(8))}});
  EXPECT_EQ(regions[0].needs.instanceRead, 10u);
  EXPECT_EQ(regions[0].needs.dataRead, 0u);
  EXPECT_TRUE(regions[0].exits.back().swapped);
}

// The block that was open as instance is the data block now: nobody looked at its length yet.
TEST(Region, ABlockThatMovedIsCheckedWhereItIs) {
  const auto regions =
      regionsOf({kExchange,
                 openBlock(1, true),
                 {Operation::LOAD, mc7::memory(Area::DataBlock, Width::Word, bitAddress(8))},
                 kEnd});
  EXPECT_EQ(count(regions[0], Opcode::Limit), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Guard), 1u);
}

}  // namespace
}  // namespace merker::translate
