// The engine of a station. It chooses block by block and region by region: the interpreter
// executes, and where a block has compiled code, that code stands in front of it.
#pragma once

#include "cpu/cpu.h"
#include "interpreter/interpreter.h"
#include "jit/native.h"
#include "station/machine_layout.h"
#include "station/translations.h"

namespace merker::station {

struct CompilerOptions {
  jit::Options jit{};
  // Into a region of fewer instructions the way is longer than through the interpreter; other
  // regions still lead on into it.
  std::uint32_t shortestEntry = 3;
};

class MixedEngine : public cpu::Engine {
 public:
  MixedEngine(const CpuModel& model, bool compiles, CompilerOptions options = {})
      : model_(model),
        layout_(layoutOf(model)),
        interpreter_(model),
        compiles_(compiles && canCompile()),
        options_(std::move(options)) {}

  static bool canCompile() { return jit::available(); }
  bool compiles() const { return compiles_; }
  // For the blocks that the CPU has, and those to come.
  void compile(bool on, cpu::Cpu& cpu);
  // The engine of `made` from now on; what is in it takes the place of what the CPU has. Not while
  // the CPU runs.
  void exchange(const Translations& made, cpu::Cpu& cpu);
  // What is in it needs no translation.
  void supply(std::shared_ptr<Translations> made);
  static std::size_t compiledBytes(const cpu::Cpu& cpu);

  // Coverage and checks, which stay with the interpreter.
  interpreter::Interpreter& interpreter() { return interpreter_; }
  const interpreter::Interpreter& interpreter() const { return interpreter_; }

  std::unique_ptr<cpu::Code> translate(const block::Block& block) override;
  void run(cpu::Machine& machine) override { interpreter_.run(machine); }
  std::uint32_t offset(const cpu::Frame& frame) const override {
    return interpreter_.offset(frame);
  }
  void probe(cpu::Code& code, cpu::Probe* probe) override { interpreter_.probe(code, probe); }
  bool keepsOldCode() const override { return interpreter_.keepsOldCode(); }
  bool watched() const override { return interpreter_.watched(); }

 private:
  void compile(interpreter::Translated& code) const;

  const CpuModel& model_;
  const jit::Layout layout_;
  interpreter::Interpreter interpreter_;
  bool compiles_;
  CompilerOptions options_;
  std::shared_ptr<Translations> supplied_;
};

}  // namespace merker::station
