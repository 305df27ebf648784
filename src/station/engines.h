// Both engines as one: the interpreter executes, and where a block has compiled code, that code
// stands in front of it.
#pragma once

#include "cpu/cpu.h"
#include "interpreter/interpreter.h"
#include "jit/native.h"
#include "station/machine_layout.h"

namespace merker::station {

struct CompilerOptions {
  jit::Options jit{};
  // Into a region of fewer instructions the way is longer than through the interpreter; other
  // regions still lead on into it.
  std::uint32_t shortestEntry = 3;
};

class Engines : public interpreter::Interpreter {
 public:
  Engines(const CpuModel& model, bool compiles, CompilerOptions options = {})
      : Interpreter(model),
        model_(model),
        layout_(layoutOf(model)),
        compiles_(compiles && canCompile()),
        options_(options) {}

  static bool canCompile() { return jit::available(); }
  bool compiles() const { return compiles_; }
  // For the blocks that the CPU has, and those to come.
  void compile(bool on, cpu::Cpu& cpu);
  std::unique_ptr<cpu::Code> translate(const block::Block& block) override;
  static std::size_t compiledBytes(const cpu::Cpu& cpu);

 private:
  void compile(interpreter::Translated& code) const;

  const CpuModel& model_;
  const jit::Layout layout_;
  bool compiles_;
  CompilerOptions options_;
};

}  // namespace merker::station
