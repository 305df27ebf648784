// Called blocks whose instructions stand in the region of their caller.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "lowering/translate.h"
#include "mc7/encoding.h"

namespace merker::translate::copies {
namespace {

using icode::Opcode;
using mc7::Instruction;
using mc7::Operand;
using mc7::Operation;

constexpr Area kFlag = Area::Flag;
Operand word(Area area, std::uint32_t byte) {
  return mc7::memory(area, Width::Word, bitAddress(byte));
}
Instruction callOf(std::uint32_t fc, Operation how = Operation::UC) {
  return {how, mc7::blockOperand(BlockKind::FC, fc)};
}
Instruction jump(Operation how, std::uint32_t words) {
  return {how, mc7::number(mc7::OperandKind::Jump, words)};
}
const Instruction kEnd{Operation::BE, {}};

class Copies : public testing::Test {
 protected:
  using Code = std::vector<Instruction>;
  void fc(std::uint32_t number, const Code& code) {
    Block& block = blocks_[number];
    block.listing = list(code);
    block.callee = {.listing = &block.listing,
                    .parameters = block.listing.parameters.data(),
                    .localBytes = 20,
                    .mark = &block};
  }
  // Of OB 1, which has 40 bytes of local data.
  std::vector<icode::Region> regionsOf(const Code& code) {
    const mc7::Listing listing = list(code);
    const auto find = [this](bool functionBlock, std::uint32_t number) -> const Callee* {
      const auto found = blocks_.find(number);
      return functionBlock || found == blocks_.end() ? nullptr : &found->second.callee;
    };
    auto regions = translate(
        listing, defaultCpuModel(),
        {.isOb = true, .localBytes = 40, .parameters = listing.parameters.data(), .find = find});
    for (icode::Region& region : regions) {
      EXPECT_EQ(icode::verify(region), "") << icode::print(region);
      icode::optimise(region);
    }
    return regions;
  }
  static std::size_t count(const icode::Region& region, Opcode code) {
    return static_cast<std::size_t>(std::ranges::count_if(
        region.ops, [code](const icode::Op& op) { return op.needed && op.code == code; }));
  }
  // Whether FC 1 stands in the region of its caller.
  bool isCopied(const Code& code) {
    fc(1, code);
    return !regionsOf({callOf(1), kEnd})[0].inlined.empty();
  }

 private:
  struct Block {
    mc7::Listing listing;
    Callee callee;
  };
  static mc7::Listing list(const Code& code) {
    std::vector<std::uint8_t> bytes;
    for (const Instruction& i : code) EXPECT_TRUE(mc7::encode(i, bytes));
    return mc7::list(bytes);
  }
  std::map<std::uint32_t, Block> blocks_;
};

const Instruction kLoad{Operation::LOAD, word(kFlag, 10)},
    kStore{Operation::TRANSFER, word(kFlag, 12)};

TEST_F(Copies, TwoCallsStandInOneRegionAndAreCheckedOnce) {
  fc(1, {kLoad, kStore, kEnd});
  const auto regions = regionsOf({callOf(1), callOf(1), kEnd});
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].instructions, 2u * 4 + 1);
  EXPECT_EQ(count(regions[0], Opcode::CanInline), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Load16), 1u);
  EXPECT_EQ(count(regions[0], Opcode::Call), 0u);
  EXPECT_EQ(regions[0].exits.back().inside, 0u);
  EXPECT_EQ(regions[0].exits.back().position, 2u);  // of the second call
}

TEST_F(Copies, AGuardLeavesTheFrameOfTheBlockBehind) {
  fc(2, {{Operation::DIV_I, {}}, kEnd});
  fc(1, {kLoad, callOf(2), kEnd});
  const auto regions = regionsOf({kLoad, callOf(1), kEnd});
  const auto& region = regions[0];
  const auto guard = std::ranges::find(region.ops, Opcode::Guard, &icode::Op::code);
  ASSERT_NE(guard, region.ops.end());
  const icode::Exit& exit = region.exits[guard->number];
  ASSERT_NE(exit.inside, 0u);
  const icode::Inlined& inner = region.inlined[exit.inside - 1];
  EXPECT_EQ(inner.number, 2u);
  EXPECT_EQ(inner.depth, 1u);
  EXPECT_EQ(inner.localBytes, 40u);
  EXPECT_EQ(inner.resume, 2u);
  EXPECT_EQ(region.inlined[inner.outer - 1].number, 1u);
  EXPECT_EQ(exit.to, 0u);
  EXPECT_EQ(exit.instructions, 4u);
}

// The interpreter, or FC 1 itself, comes back there.
TEST_F(Copies, ARegionBeginsBehindABlockWithWaysOut) {
  fc(1, {kLoad, jump(Operation::SPB, 3), kStore, kEnd});
  const auto regions = regionsOf({callOf(1), kLoad, kEnd});
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].inlined.size(), 1u);
  EXPECT_EQ(regions[1].first, 1u);
  fc(1, {kLoad, {Operation::BEB, {}}, kStore, kEnd});
  EXPECT_EQ(regionsOf({callOf(1), kLoad, kEnd}).size(), 2u);
}

// Behind the 40 bytes of OB 1, and not beyond its own 20.
TEST_F(Copies, LocalDataFollowThoseOfTheCaller) {
  EXPECT_TRUE(isCopied({kLoad, {Operation::TRANSFER, word(Area::Local, 2)}, kEnd}));
  const auto regions = regionsOf({callOf(1), kEnd});
  ASSERT_EQ(count(regions[0], Opcode::Store16), 1u);
  const auto store = std::ranges::find(regions[0].ops, Opcode::Store16, &icode::Op::code);
  EXPECT_EQ(store->space, icode::Space::Local);
  EXPECT_EQ(store->place, 42u);
  EXPECT_EQ(regions[0].needs.local, 0u);
  EXPECT_FALSE(isCopied({kLoad, {Operation::TRANSFER, word(Area::Local, 20)}, kEnd}));
}

// S7-INSTR-108: behind BE the caller has its registers again.
TEST_F(Copies, WhatTheCallerGetsBackIsKept) {
  const Instruction open{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)};
  for (const Instruction& change :
       {open, Instruction{Operation::TAR, {}}, Instruction{Operation::SWAP_DB, {}}}) {
    EXPECT_TRUE(isCopied({change, kLoad, kEnd}));
    const auto regions = regionsOf({callOf(1), kEnd});
    EXPECT_TRUE(regions[0].inlined[0].keeps);
    EXPECT_EQ(count(regions[0], Opcode::KeepFrame), 1u);
    EXPECT_EQ(count(regions[0], Opcode::GiveBack), 1u);
    EXPECT_FALSE(isCopied({{Operation::BEB, {}}, change, kEnd}));
  }
  EXPECT_TRUE(isCopied({kLoad, kEnd}));
  EXPECT_EQ(count(regionsOf({callOf(1), kEnd})[0], Opcode::KeepFrame), 0u);
}

TEST_F(Copies, OthersAreCalled) {
  EXPECT_TRUE(isCopied({kLoad, kEnd}));
  EXPECT_FALSE(isCopied({kLoad, callOf(1), kEnd})) << "calls itself";
  EXPECT_FALSE(isCopied({kLoad, callOf(7), kEnd})) << "calls an unknown block";
  EXPECT_FALSE(isCopied({kLoad, {Operation::SIN, {}}, kEnd}));
  EXPECT_FALSE(isCopied({kLoad, jump(Operation::SPB, static_cast<std::uint32_t>(-1)), kEnd}))
      << "has a loop";
  EXPECT_FALSE(isCopied({kLoad, kStore})) << "has no end";
  Code many(60, kLoad);
  many.push_back(kEnd);
  EXPECT_FALSE(isCopied(many));
}

// Each of the three hundred calls would bring its own forty instructions.
TEST_F(Copies, ARegionAndABlockHaveLimits) {
  fc(1, Code(30, kLoad));
  Code body(30, kLoad);
  body.push_back(kEnd);
  fc(1, body);
  Code calls(300, callOf(1));
  calls.push_back(kEnd);
  std::size_t copied = 0;
  for (const icode::Region& region : regionsOf(calls)) {
    EXPECT_LE(region.instructions, kLongestRegion);
    copied += region.inlined.size();
  }
  EXPECT_GT(copied, 50u);
  EXPECT_LT(copied, 100u);
}

// Twelve blocks that call each other come to more instructions than 32 bits count: to 45, by
// overflow.
TEST_F(Copies, MoreInstructionsThanAnyRegionHoldsAreNotCopied) {
  constexpr std::size_t kCalls[] = {15, 27, 31, 36, 15, 22, 20, 18, 25, 38, 6};
  fc(1, {kLoad, kLoad, kStore, kEnd});
  Code calls{callOf(1)};
  for (std::uint32_t i = 0; i < std::size(kCalls); ++i) {
    Code body(kCalls[i], callOf(i + 1));
    body.push_back(kEnd);
    fc(i + 2, body);
    calls.push_back(callOf(i + 2));
  }
  calls.push_back(kEnd);
  for (const icode::Region& region : regionsOf(calls)) {
    EXPECT_LE(region.instructions, kLongestRegion);
    for (const icode::Inlined& block : region.inlined) EXPECT_LE(block.number, 2u);
  }
}

}  // namespace
}  // namespace merker::translate::copies
