#include <gtest/gtest.h>

#include "base/bytes.h"
#include "rig.h"

namespace merker::interpreter::test {
namespace {

const Instruction kEnd{Operation::BE, {}};
Instruction uc(BlockKind kind, std::uint32_t number) {
  return {Operation::UC, mc7::blockOperand(kind, number)};
}
Operand parameter(Width width, std::uint32_t index) {
  return {.kind = OperandKind::Parameter, .width = width, .value = index};
}

// OB 1 that calls FC 1 with a list of pointers (MC7 section 7.2).
block::Block caller(const std::vector<std::uint32_t>& list,
                    const std::vector<Instruction>& behind = {}) {
  block::Block ob = codeBlock(BlockKind::OB, 1, {});
  ob.code = assemble({uc(BlockKind::FC, 1)});
  appendWord(ob.code, 0x700B);
  appendWord(ob.code, static_cast<std::uint32_t>(2 * list.size() + 2));
  for (const std::uint32_t pointer : list) appendDWord(ob.code, pointer);
  const std::vector<std::uint8_t> rest = assemble(behind);
  ob.code.insert(ob.code.end(), rest.begin(), rest.end());
  appendWord(ob.code, 0x6500);
  return ob;
}

// S7-PAR-01: by reference, at the moment of use; the list is jumped over.
TEST(Call, ParametersAreReferences) {
  block::Block fc = codeBlock(BlockKind::FC, 1,
                              {{Operation::LOAD, parameter(Width::Word, 0)},
                               {Operation::TRANSFER, parameter(Width::Word, 1)},
                               {Operation::AND, parameter(Width::Bit, 2)},
                               {Operation::ASSIGN, parameter(Width::Bit, 3)},
                               kEnd});
  const std::vector<std::uint32_t> list{
      pointer(Area::Flag, bitAddress(10)), pointer(Area::Output, bitAddress(4)),
      pointer(Area::Input, bitAddress(1, 6)), pointer(Area::CallerLocal, bitAddress(20, 1))};
  auto program = std::make_shared<block::Program>();
  Rig rig({});
  for (block::Block& b : std::vector<block::Block>{
           caller(list, {{Operation::LOAD, mc7::memory(Area::Local, Width::Byte, bitAddress(20))},
                         {Operation::TRANSFER, flagWord(30)}}),
           fc})
    program->emplace(b.id, b);
  rig.cpu().load(program);
  rig.start();
  rig.machine().areas.flag(10)[0] = 0x12;
  rig.machine().areas.flag(10)[1] = 0x34;
  *rig.machine().areas.input(1) = 0x40;
  rig.finish();
  ASSERT_FALSE(rig.stopped());
  EXPECT_EQ(rig.machine().areas.output(4)[0], 0x12);
  EXPECT_EQ(rig.machine().areas.output(4)[1], 0x34);
  EXPECT_EQ(rig.machine().areas.flag(30)[1], 0x02);
}

// A parameter that the call does not supply: area error, never a crash.
TEST(Call, MissingParameterIsAnAreaError) {
  Rig rig({uc(BlockKind::FC, 1), {Operation::SPA, jump(2)}},
          {codeBlock(BlockKind::FC, 1, {{Operation::LOAD, parameter(Width::Word, 7)}, kEnd})});
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.stopEvent(), 0x4562u);
}

// S7-INSTR-108, S7-INSTR-109, S7-PAR-09, S7-FB-13, S7-INSTR-129: BE gives back DB, DI, AR2 and MCR;
// AKKUs, AR1 and VKE are the callee's.
TEST(Call, EndRestoresTheCaller) {
  for (const Operation end : {Operation::BE, Operation::BEA, Operation::BEB}) {
    Rig rig({{Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)},
             {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 2, true)},
             {Operation::MCRA, {}},
             uc(BlockKind::FC, 1),
             {Operation::NOP0, {}}},
            {codeBlock(BlockKind::FC, 1,
                       {{Operation::SWAP_DB, {}},
                        {Operation::LAR1, mc7::constant(ConstantFormat::Pointer, 8)},
                        {Operation::LAR2, mc7::constant(ConstantFormat::Pointer, 16)},
                        {Operation::LOAD, word(77)},
                        {Operation::SET, {}},
                        {end, {}},
                        kEnd}),
             dataBlock(1, 2), dataBlock(2, 2)});
    rig.start();
    rig.registers().ar2 = 0x1234;
    rig.status().os = true;
    rig.step(4);
    EXPECT_FALSE(rig.machine().mcrActive);  // off in the called block
    EXPECT_FALSE(rig.status().os);
    rig.step(6);
    EXPECT_EQ(rig.registers().db.number, 1);
    EXPECT_EQ(rig.registers().di.number, 2);
    EXPECT_EQ(rig.registers().ar2, 0x1234u);
    EXPECT_EQ(rig.registers().ar1, 8u);
    EXPECT_EQ(rig.accu1(), 77u);
    EXPECT_TRUE(rig.status().rlo);
    EXPECT_TRUE(rig.machine().mcrActive);
  }
}

// S7-INSTR-107, S7-FC-03, S7-FC-10
TEST(Call, Conditional) {
  for (const bool rlo : {false, true}) {
    Rig rig({{rlo ? Operation::SET : Operation::CLR, {}},
             {Operation::CC, mc7::blockOperand(BlockKind::FB, 1)},
             {Operation::NOP0, {}}},
            {codeBlock(BlockKind::FB, 1,
                       {{Operation::LOAD, word(5)}, {Operation::TRANSFER, flagWord(0)}, kEnd})});
    rig.start();
    rig.step(2);
    EXPECT_TRUE(rig.status().rlo);
    rig.finish();
    EXPECT_EQ(rig.machine().areas.flag(0)[1], rlo ? 5 : 0);
  }
}

// S7-INSTR-110
TEST(Call, ConditionalEnd) {
  Rig rig({{Operation::CLR, {}},
           {Operation::BEB, {}},
           {Operation::ASSIGN, flag(0, 0)},
           {Operation::SET, {}},
           {Operation::BEB, {}},
           {Operation::ASSIGN, flag(0, 1)}});
  rig.start();
  rig.finish();
  EXPECT_EQ(*rig.machine().areas.flag(0), 0x01);
}

// Blocks 1..n, each calling the next one.
std::vector<block::Block> chainOf(unsigned depth, std::uint32_t localBytes = 2) {
  std::vector<block::Block> blocks;
  for (unsigned i = 1; i <= depth; ++i) {
    std::vector<Instruction> code;
    if (i < depth) code.push_back(uc(BlockKind::FB, i + 1));
    code.push_back(kEnd);
    blocks.push_back(codeBlock(BlockKind::FB, static_cast<std::uint16_t>(i), code));
    blocks.back().localBytes = localBytes;
  }
  return blocks;
}

// S7-CPU-26
TEST(Call, NestingDepth) {
  Rig eight({uc(BlockKind::FB, 1)}, chainOf(8));
  eight.start();
  eight.finish();
  EXPECT_FALSE(eight.stopped());
  Rig nine({uc(BlockKind::FB, 1)}, chainOf(9));
  nine.start();
  nine.finish();
  EXPECT_EQ(nine.stopEvent(), 0x4575u);
}

// S7-CPU-25, S7-OPND-03
TEST(Call, LocalData) {
  Rig fits({uc(BlockKind::FB, 1)}, chainOf(5, 90));  // 60 + 5 * 90 = 510
  fits.start();
  fits.finish();
  EXPECT_FALSE(fits.stopped());
  Rig tooMuch({uc(BlockKind::FB, 1)}, chainOf(5, 92));
  tooMuch.start();
  tooMuch.finish();
  EXPECT_EQ(tooMuch.stopEvent(), 0x4576u);
}

// A program that calls itself without end stops, it does not crash.
TEST(Call, EndlessRecursionStops) {
  Rig rig({uc(BlockKind::FB, 1)}, {codeBlock(BlockKind::FB, 1, {uc(BlockKind::FB, 1), kEnd})},
          *findCpuModel("generic"));
  rig.start();
  rig.finish();
  EXPECT_EQ(rig.stopEvent(), 0x4575u);
}

}  // namespace
}  // namespace merker::interpreter::test
