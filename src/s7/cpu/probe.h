// The look at single instructions that the test functions need: breakpoints, single step, program
// status. Any engine can offer it; a block without a probe runs as if there were none.
#pragma once

#include <cstdint>

#include "cpu/machine.h"

namespace merker::cpu {

class Probe {
 public:
  virtual ~Probe() = default;
  // Before the instruction at `offset` of the top block. True: it is not executed and costs no
  // time; the engine leaves the program and begins with it when it runs again.
  virtual bool before(Machine& machine, std::uint32_t offset) = 0;
  // After it, also when it jumped, ended its block or stopped the CPU. Not when it opened a block
  // (call, error OB): the next `before` in the same frame then shows what it left behind.
  virtual void after(Machine& machine, const Code& code, std::uint32_t offset) = 0;
};

}  // namespace merker::cpu
