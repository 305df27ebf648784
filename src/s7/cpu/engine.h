// The two seams of the CPU: what executes blocks, and what answers calls of system blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "cpu/machine.h"
#include "cpu/probe.h"

namespace merker::cpu {

class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::unique_ptr<Code> translate(const block::Block& block) = 0;
  // Runs the top block from where it stands until the first instruction boundary at or after
  // machine.horizon. Then top->resume is the place to go on, or levelEnded says that the last block
  // of the level has ended.
  virtual void run(Machine& machine) = 0;
  // After a fault: the next instruction of the top block, as an offset in its code.
  virtual std::uint32_t offset(const Frame& frame) const = 0;
  // From now on each instruction of this block goes past the probe; null: none. Not while `run`
  // runs.
  virtual void probe(Code& code, Probe* probe) = 0;
  // Whether results point into code and blocks that nobody runs any more: checks, coverage.
  virtual bool keepsOldCode() const { return false; }
  // Whether somebody looks at single instructions or counts them: each of them must be executed.
  virtual bool watched() const { return false; }
};

// A call of SFC n, SFB n or of a library FC that the CPU brings.
struct SystemCall {
  Cpu& cpu;
  Machine& machine;
  BlockId block;
  std::span<const std::uint32_t> parameters;  // FC, SFC: pointers in interface order
};

class SystemServices {
 public:
  virtual ~SystemServices() = default;
  // False: the CPU has no such block.
  virtual bool call(const SystemCall& call) = 0;
  // Whether a call comes to the same again as long as memory is the same; what it looks at beside
  // memory is then in Machine::outlook.
  virtual bool steady(BlockId) const { return false; }
  // Warm and cold restart: aborts jobs that span several calls.
  virtual void restart() {}
};

}  // namespace merker::cpu
