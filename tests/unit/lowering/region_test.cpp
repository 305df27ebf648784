// What becomes of instructions in the intermediate code.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "lowering/translate.h"
#include "mc7/encoding.h"

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

TEST(Region, ABitIsAssignedOnceAsLongAsItIsTheSame) {
  const Operand x = bit(Area::Input, 4, 0), y = bit(Area::Input, 4, 1);
  const Operand to = bit(Area::Output, 4, 0), other = bit(Area::Output, 4, 1);
  const auto assigned = [](const Operand& from, const Operand& place) {
    return std::vector<mc7::Instruction>{{Operation::AND, from}, {Operation::ASSIGN, place}};
  };
  std::vector<mc7::Instruction> code{{Operation::SET, {}}};
  const auto add = [&](const Operand& from, const Operand& place) {
    std::ranges::copy(assigned(from, place), std::back_inserter(code));
  };
  add(x, to), add(y, other), add(x, to);
  EXPECT_EQ(count(regionsOf(code)[0], Opcode::Insert), 2u);
  add(y, to);
  EXPECT_EQ(count(regionsOf(code)[0], Opcode::Insert), 3u);
}

// S7-INSTR-48: the same block again, as between one call of an FB and the next.
TEST(Region, ABlockIsOpenedOnce) {
  const auto open = [](std::uint32_t number, bool instance) {
    return mc7::Instruction{Operation::OPEN, mc7::blockOperand(BlockKind::DB, number, instance)};
  };
  const mc7::Instruction swap{Operation::SWAP_DB, {}};
  const auto opens = [](const std::vector<mc7::Instruction>& code) {
    return count(regionsOf(code)[0], Opcode::Open);
  };
  EXPECT_EQ(opens({open(1, true), swap, swap, open(1, true), kEnd}), 1u);
  EXPECT_EQ(opens({open(1, true), swap, open(1, false), kEnd}), 1u);
  EXPECT_EQ(opens({open(1, true), open(1, false), kEnd}), 2u);
  EXPECT_EQ(opens({open(1, true), open(2, true), open(1, true), kEnd}), 3u);
}

// What stands in an accumulator only for whoever looks at the CPU is put together for him.
TEST(Region, AWordInTheAccumulatorIsLeftToTheExits) {
  const auto regions = regionsOf({{Operation::LOAD, word(10)},
                                  {Operation::LOAD, word(12)},
                                  kAddInt,
                                  {Operation::TRANSFER, word(14)},
                                  kEnd});
  const auto late = [](const icode::Op& op) { return op.code == Opcode::Zext16 && op.late; };
  EXPECT_EQ(std::ranges::count_if(regions[0].ops, late), 1);
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

// One operand that the row takes.
Operand anyOperand(Operand operand) {
  const bool inMemory = operand.kind == OperandKind::Memory ||
                        operand.kind == OperandKind::MemoryIndirect ||
                        operand.kind == OperandKind::RegisterIndirect;
  if (inMemory && operand.area == Area::None) operand.area = Area::Flag;
  const bool indirect =
      operand.kind == OperandKind::MemoryIndirect || operand.kind == OperandKind::TimerIndirect ||
      operand.kind == OperandKind::CounterIndirect || operand.kind == OperandKind::BlockIndirect;
  if (indirect && operand.pointerArea == Area::None) operand.pointerArea = Area::Flag;
  if ((operand.kind == OperandKind::RegisterIndirect ||
       operand.kind == OperandKind::RegisterCrossing) &&
      operand.reg == 0)
    operand.reg = 1;
  if (operand.kind == OperandKind::Block || operand.kind == OperandKind::ShiftCount)
    operand.value = 1;
  if (operand.kind == OperandKind::Jump) operand.value = 3;
  return operand;
}

// Rows of the instruction tables that the interpreter keeps for itself, whatever stands around
// them.
std::string untranslated(const CpuModel& model) {
  std::string left;
  for (const mc7::Encoding& row : mc7::encodings()) {
    std::vector<std::uint8_t> code;
    mc7::Instruction instruction{row.operation, anyOperand(row.operand)};
    if (!mc7::encode(row, instruction.operand, code)) {
      instruction.operand.value = 300;  // a row for what has no room in the short one
      if (!mc7::encode(row, instruction.operand, code)) continue;
    }
    for (int i = 0; i < 6; ++i) EXPECT_TRUE(mc7::encode({Operation::NOP0, {}}, code));
    EXPECT_TRUE(mc7::encode(kEnd, code));
    const auto regions = translate(mc7::list(code), model);
    if (regions.empty() || regions[0].first != 0)
      left += mc7::text(instruction, Mnemonics::German) + "; ";
  }
  return left;
}

TEST(Region, EveryRowHasATranslationBut) {
  // Brackets alone; the time of a timer whose number is not in the code, for the interpreter notes
  // who loads it; what the host would round otherwise; MCR; system functions without parameters.
  const std::string left =
      "U(; O(; UN(; ON(; X(; XN(; ); L     T [MW 0]; LC    T [MW 0]; L     T #P0; LC    T #P0; "
      "L     P##P0; L     P##P0; EXP; LN; SIN; COS; "
      "TAN; ASIN; ACOS; ATAN; MCRA; MCRD; MCR(; )MCR; UC    SFC 1; UC    SFB 1; ";
  EXPECT_EQ(untranslated(*findCpuModel("generic-4")), left);
  std::string withTwo = left;  // ENT and LEAVE need four accumulators
  withTwo.insert(withTwo.find("ATAN; ") + 6, "ENT; LEAVE; ");
  EXPECT_EQ(untranslated(defaultCpuModel()), withTwo);
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

// There is nothing to jump over.
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

mc7::Instruction loopBack(std::int32_t words) {
  return {Operation::LOOP,
          {.kind = OperandKind::Jump, .value = static_cast<std::uint32_t>(-words)}};
}
const mc7::Instruction kCount{Operation::TRANSFER, word(100)}, kCounted{Operation::LOAD, word(100)};

// Each turn can be the last one; the longest region ends in front of a whole turn, and behind the
// loop another one begins.
TEST(Region, ALoopGoesOnWithItsNextTurns) {
  const auto regions = regionsOf({kCount, kAddInt, kCounted, loopBack(3), kEnd});
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].instructions, kLongestRegion);
  EXPECT_EQ(count(regions[0], Opcode::BranchUnless), kLongestRegion / 4 - 1);
  EXPECT_EQ(count(regions[0], Opcode::BranchIf), 1u);
  for (std::uint32_t turn = 1; turn < kLongestRegion / 4; ++turn) {
    EXPECT_EQ(regions[0].exits[turn - 1].to, 4u);
    EXPECT_EQ(regions[0].exits[turn - 1].instructions, 4 * turn);
  }
  EXPECT_EQ(regions[1].first, 4u);
}

// Over the end of the branch that SPB left out, which begins a region of its own.
TEST(Region, ALoopGoesOnBehindABranch) {
  const Operand over{.kind = OperandKind::Jump, .value = 3};
  const auto regions =
      regionsOf({kCount, {Operation::SPBI, over}, kAddInt, kCounted, loopBack(5), kEnd});
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0].instructions, kLongestRegion / 5 * 5 + 3);
  EXPECT_EQ(regions[1].first, 3u);
  EXPECT_EQ(regions[2].first, 5u);
}

// The lower bits of these constants are 0: that alone must not make one push out the other.
TEST(Region, EqualOperationsOnRealsAreMadeOnce) {
  const auto real = [](std::uint32_t bits) {
    return mc7::Instruction{Operation::LOAD, mc7::constant(ConstantFormat::Real, bits)};
  };
  const auto regions = regionsOf({kCount,
                                  real(0x3FC0'0000),
                                  real(0x4040'0000),
                                  {Operation::MUL_R, {}},
                                  kCounted,
                                  loopBack(9),
                                  kEnd});
  EXPECT_EQ(count(regions[0], Opcode::MulReal), 1u);
}

TEST(Region, AWordThatWasWrittenIsKnown) {
  const auto regions = regionsOf({kCount, kCounted, kAddInt, kEnd});
  EXPECT_EQ(count(regions[0], Opcode::Load16), 0u);
}

// The bit in brackets lies elsewhere in each turn.
TEST(Region, BracketsOfEachTurnLookAtTheirOwnOperands) {
  const Operand behind = mc7::registerIndirect(Area::Flag, Width::Bit, 1, 0);
  const mc7::Instruction advance{Operation::ADD_AR1,
                                 {.kind = OperandKind::Pointer, .value = bitAddress(1)}};
  const auto regions = regionsOf({{Operation::AND_OPEN, {}},
                                  {Operation::AND, behind},
                                  {Operation::CLOSE, {}},
                                  advance,
                                  loopBack(6),
                                  kEnd});
  EXPECT_EQ(count(regions[0], Opcode::Index), kLongestRegion / 5);
}

TEST(Region, AnAddressThatIsKnownIsAPlace) {
  const Operand pointer = mc7::constant(
      ConstantFormat::Pointer, static_cast<std::uint32_t>(Area::Flag) << 24 | bitAddress(10));
  const Operand crossing = mc7::registerCrossing(Width::Word, 1, bitAddress(2));
  const auto regions =
      regionsOf({{Operation::LAR1, pointer}, {Operation::LOAD, crossing}, kAddInt, kEnd});
  EXPECT_EQ(count(regions[0], Opcode::Locate), 0u);
  const auto load = std::find_if(regions[0].ops.begin(), regions[0].ops.end(),
                                 [](const icode::Op& op) { return op.code == Opcode::Load16; });
  ASSERT_NE(load, regions[0].ops.end());
  EXPECT_EQ(load->place, 12u);
}

TEST(Region, AnyBytesGiveValidRegions) {
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> code(random() % 200);
    for (std::uint8_t& byte : code)
      byte = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    std::uint32_t next = 0;
    for (const icode::Region& region : translate(mc7::list(code), defaultCpuModel())) {
      ASSERT_EQ(icode::verify(region), "") << icode::print(region);
      ASSERT_GE(region.first, next);
      next = region.first + 1;
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
