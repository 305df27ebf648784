// A CPU with a program of single instructions, to step through.
#pragma once

#include <initializer_list>
#include <memory>
#include <vector>

#include "cpu/cpu.h"
#include "interpreter/interpreter.h"
#include "mc7/instruction.h"

namespace merker::interpreter::test {

using mc7::Instruction;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

struct NoServices : cpu::SystemServices {
  bool call(const cpu::SystemCall&) override { return false; }
};

std::vector<std::uint8_t> assemble(const std::vector<Instruction>& instructions);
block::Block codeBlock(BlockKind kind, std::uint16_t number,
                       const std::vector<Instruction>& instructions);
block::Block dataBlock(std::uint16_t number, std::size_t bytes);

// Constants and operands in few letters.
Operand word(std::uint32_t bits);
Operand doubleWord(std::uint32_t bits);
Operand shiftBy(std::uint32_t count);
Operand flag(std::uint32_t byte, std::uint32_t bit);
Operand flagWord(std::uint32_t byte);
Operand jump(std::int32_t words);

class Rig {
 public:
  // OB 1 of these instructions; further blocks beside it.
  explicit Rig(std::vector<Instruction> ob1, std::vector<block::Block> others = {},
               const CpuModel& model = defaultCpuModel());

  void start();               // up to the first instruction of OB 1
  void step(unsigned n = 1);  // instructions
  void finish();              // OB 1 to its end, or STOP
  cpu::Machine& machine() { return cpu_.machine(); }
  cpu::Registers& registers() { return machine().registers; }
  cpu::StatusWord& status() { return machine().registers.status; }
  cpu::Cpu& cpu() { return cpu_; }
  std::uint32_t accu1() { return registers().accu[0]; }
  bool stopped() { return cpu_.mode() == cpu::Mode::Stop; }
  unsigned stopEvent() { return stopped() ? cpu_.state().stopEvent().event : 0u; }

 private:
  NoServices services_;
  Interpreter engine_;
  cpu::Cpu cpu_;
};

// One instruction in a state of one's own.
struct State {
  std::array<std::uint32_t, 4> accu{};
  std::uint32_t status = 0;
};
cpu::Registers execute(const Instruction& instruction, const State& before,
                       const CpuModel& model = defaultCpuModel());

}  // namespace merker::interpreter::test
