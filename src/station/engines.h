// Both engines as one: the interpreter executes, and where a block has compiled code, that code
// stands in front of it.
#pragma once

#include "cpu/cpu.h"
#include "interpreter/interpreter.h"
#include "jit/native.h"

namespace merker::station {

class Engines : public interpreter::Interpreter {
 public:
  Engines(const CpuModel& model, bool compiles, jit::Options options = {})
      : Interpreter(model), model_(model), compiles_(compiles && canCompile()), options_(options) {}

  static bool canCompile() { return jit::available(); }
  bool compiles() const { return compiles_; }
  // For the blocks that the CPU has, and those to come.
  void compile(bool on, cpu::Cpu& cpu);
  std::unique_ptr<cpu::Code> translate(const block::Block& block) override;
  static std::size_t compiledBytes(const cpu::Cpu& cpu);

 private:
  void compile(interpreter::Translated& code) const;

  const CpuModel& model_;
  bool compiles_;
  jit::Options options_;
};

}  // namespace merker::station
