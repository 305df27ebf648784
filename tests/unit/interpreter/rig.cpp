#include "rig.h"

#include <gtest/gtest.h>

namespace merker::interpreter::test {

std::vector<std::uint8_t> assemble(const std::vector<Instruction>& instructions) {
  std::vector<std::uint8_t> code;
  for (const Instruction& instruction : instructions)
    EXPECT_TRUE(mc7::encode(instruction, code)) << mc7::text(instruction, Mnemonics::German);
  return code;
}

block::Block codeBlock(BlockKind kind, std::uint16_t number,
                       const std::vector<Instruction>& instructions) {
  block::Block block;
  block.id = {kind, number};
  block.localBytes = kind == BlockKind::OB ? 60 : 20;
  block.code = assemble(instructions);
  return block;
}

block::Block dataBlock(std::uint16_t number, std::size_t bytes) {
  block::Block block;
  block.id = {BlockKind::DB, number};
  block.initialData.resize(bytes);
  block.actualData.resize(bytes);
  return block;
}

Operand word(std::uint32_t bits) { return mc7::constant(ConstantFormat::Word, bits); }
Operand doubleWord(std::uint32_t bits) { return mc7::constant(ConstantFormat::DWord, bits); }
Operand shiftBy(std::uint32_t count) { return mc7::number(OperandKind::ShiftCount, count); }
Operand flag(std::uint32_t byte, std::uint32_t bit) {
  return mc7::memory(Area::Flag, Width::Bit, bitAddress(byte, bit));
}
Operand flagWord(std::uint32_t byte) {
  return mc7::memory(Area::Flag, Width::Word, bitAddress(byte));
}
Operand jump(std::int32_t words) {
  return mc7::number(OperandKind::Jump, static_cast<std::uint32_t>(words));
}

Rig::Rig(std::vector<Instruction> ob1, std::vector<block::Block> others, const CpuModel& model)
    : engine_(model), cpu_(model, engine_, services_, 0) {
  auto program = std::make_shared<block::Program>();
  ob1.push_back({Operation::BE, {}});
  program->emplace(BlockId{BlockKind::OB, 1}, codeBlock(BlockKind::OB, 1, ob1));
  for (block::Block& other : others) program->emplace(other.id, std::move(other));
  cpu_.load(std::move(program));
}

void Rig::start() {
  EXPECT_TRUE(cpu_.restart(cpu::Restart::ManualWarm));
  while (cpu_.betweenCycles() && !stopped()) cpu_.step(Instant::never());
}

void Rig::step(unsigned n) {
  for (; n > 0; --n) {
    machine().horizon = Instant{INT64_MIN};
    engine_.run(machine());
  }
}

void Rig::finish() {
  const std::uint64_t before = cpu_.cycle().count();
  while (cpu_.cycle().count() == before && !stopped()) cpu_.step(Instant::never());
}

cpu::Registers execute(const Instruction& instruction, const State& before, const CpuModel& model) {
  Rig rig({instruction}, {}, model);
  rig.start();
  rig.registers().accu = before.accu;
  rig.status() = cpu::StatusWord::fromWord(before.status);
  rig.step();
  return rig.registers();
}

}  // namespace merker::interpreter::test
