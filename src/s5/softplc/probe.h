// The look at single instructions that the test functions need: breakpoints, single step, program
// status. A block without a probe runs as if there were none.
#pragma once

#include <optional>

#include "softplc/machine.h"

namespace merker::sinumerik {

// An instruction in a code block. B and what it processes are one; the jump over the parameter
// list of a function block belongs to its call.
struct CodePlace {
  mc5::BlockId block;        // in whose code it lies: a jump may lead out of the running block
  std::uint32_t offset = 0;  // words of code, without the header
  std::size_t levels = 1;    // 2: OB 2, or what it called, has interrupted OB 1
  std::size_t frames = 1;    // blocks of all levels down to the running one
  bool operator==(const CodePlace&) const = default;
};

// The next instruction of the running level. Nothing between two cycles.
std::optional<CodePlace> nextPlace(const Machine& machine);

// What an instruction left behind.
struct Passed {
  const Registers& registers;  // of its level, also when that has ended
  bool blockEnded = false, levelEnded = false;
  bool trapped = false;  // it raises an alarm; the accumulators are as the alarm shows them
};

class Probe {
 public:
  virtual ~Probe() = default;
  // Before an instruction of the block. True: it is not executed and costs no time; the PLC goes to
  // HALT in front of it and begins with it, and with this question, when it resumes.
  virtual bool before(const Machine& machine, const CodePlace& place) = 0;
  // After it, also when it jumped, ended its block or stops the PLC. Not when it opened a block:
  // the next `before` in the same frame then shows what it left behind.
  virtual void after(const Machine& machine, const CodePlace& place, const Passed& passed) = 0;
};

}  // namespace merker::sinumerik
