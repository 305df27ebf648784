// The engine of a station. It chooses block by block and region by region: the interpreter
// executes, and where a block has compiled code, that code stands in front of it.
#pragma once

#include "base/payback.h"
#include "cpu/cpu.h"
#include "interpreter/interpreter.h"
#include "jit/native.h"
#include "station/block_copies.h"
#include "station/machine_layout.h"
#include "station/translations.h"

namespace merker::station {

struct CompilerOptions {
  jit::Options jit{};
  // Into a region of fewer instructions the way is longer than through the interpreter; other
  // regions still lead on into it.
  std::uint32_t shortestEntry = 3;
  // In interpreted instructions, what compiling costs: to begin with, each block, each instruction
  // (docs/performance.md, "When code is compiled").
  std::uint64_t begin = 20'000, perBlock = 10'000, perInstruction = 100;
};

class TranslationThread;

class MixedEngine : public cpu::Engine {
 public:
  MixedEngine(const CpuModel& model, bool compiles, CompilerOptions options = {});
  ~MixedEngine() override;

  static bool canCompile() { return jit::available(); }
  bool compiles() const { return compiles_; }
  // For the blocks that the CPU has, and those to come.
  void compile(bool on, cpu::Cpu& cpu);
  // The same by itself as soon as it pays; in another thread: after a wait that is worth one.
  void compileWhenItPays(const cpu::Cpu& cpu, bool elsewhere);
  // After so many instructions.
  void compileAfter(std::uint64_t interpreted) { payback_.begin(interpreted); }
  // The engine of `made` from now on; what is in it takes the place of what the CPU has. Not while
  // the CPU runs.
  void exchange(const Translations& made, cpu::Cpu& cpu);
  // What is in it needs no translation.
  void supply(std::shared_ptr<Translations> made);
  static std::size_t compiledBytes(const cpu::Cpu& cpu);

  // Coverage and checks, which stay with the interpreter.
  interpreter::Interpreter& interpreter() { return interpreter_; }
  const interpreter::Interpreter& interpreter() const { return interpreter_; }

  // Compiled at once if it calls none; otherwise when the others are known, by `link` or `run`.
  std::unique_ptr<cpu::Code> translate(const block::Block& block) override;
  void link(interpreter::Translated& code, BlockCopies& copies) const;
  void run(cpu::Machine& machine) override;
  std::uint32_t offset(const cpu::Frame& frame) const override {
    return interpreter_.offset(frame);
  }
  void probe(cpu::Code& code, cpu::Probe* probe) override { interpreter_.probe(code, probe); }
  bool keepsOldCode() const override { return interpreter_.keepsOldCode(); }
  bool watched() const override { return interpreter_.watched(); }

 private:
  void compile(interpreter::Translated& code, BlockCopies& copies) const;
  void compileTheRest(cpu::Cpu& cpu);
  void link(cpu::Cpu& cpu);
  std::uint64_t price(const cpu::Cpu& cpu) const;
  void takeWhatPays(cpu::Cpu& cpu);

  const CpuModel& model_;
  const jit::Layout layout_;
  interpreter::Interpreter interpreter_;
  bool compiles_;
  CompilerOptions options_;
  std::shared_ptr<Translations> supplied_;
  Payback payback_;
  std::unique_ptr<TranslationThread> elsewhere_;  // null: compiles here
  bool linked_ = true;                            // no block is new since they were compiled
  bool pays_ = false;                             // it was waited for, and not yet taken
};

}  // namespace merker::station
