// The loaded blocks and what the engine made of them (S7-CYCLE-05, S7-LIM-04, S7-MEM-04). Fills the
// block tables of the machine.
#pragma once

#include <memory>
#include <vector>

#include "cpu/engine.h"

namespace merker::cpu {

class LoadMemory {
 public:
  LoadMemory(Machine& machine, Engine& engine) : machine_(machine), engine_(engine) {}
  const std::shared_ptr<const block::Program>& program() const { return program_; }
  const std::vector<std::unique_ptr<Code>>& code() const { return code_; }
  bool probe(BlockId block, Probe* probe) const;  // false: no such code block

  // Instead of everything that was loaded.
  void load(std::shared_ptr<const block::Program> program);
  // The same program with blocks changed, added or deleted, for the next `activate`.
  void download(std::shared_ptr<const block::Program> program) { downloaded_ = std::move(program); }
  bool downloaded() const { return downloaded_ != nullptr; }
  // All changes at once. Unchanged blocks keep their translation and their values.
  void activate();

 private:
  void translate(const block::Program* before);
  void exchangeData(const block::Program& before);
  void dropOldCode();

  Machine& machine_;
  Engine& engine_;
  std::shared_ptr<const block::Program> program_, downloaded_;
  std::vector<std::unique_ptr<Code>> code_;
  // Of earlier downloads, if results still point into them (Engine::keepsOldCode).
  std::vector<std::shared_ptr<const block::Program>> oldPrograms_;
};

}  // namespace merker::cpu
