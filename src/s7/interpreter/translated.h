// A block as this engine runs it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "interpreter/op.h"

namespace merker::cpu {
class Probe;
}

namespace merker::interpreter {

class Recorder;
class Compiled;

// What else happens at an instruction: checks (//=) and counting for coverage. Only blocks that
// have one of them carry such a list, as long as `ops`.
struct Side {
  Handler original = nullptr;
  std::uint32_t firstCheck = 0, checks = 0;  // numbers in the recorder
  std::uint32_t afterCall = 0;  // op that evaluates the checks when a called block has returned
};

struct Translated : cpu::Code {
  std::vector<Op> ops;                    // instructions, two stops, then the ops of `afterCall`
  std::uint32_t instructionCount = 0;     // ops that stand for instructions
  std::vector<std::uint32_t> parameters;  // of all calls, one list behind the other
  std::vector<Side> side;
  mutable std::vector<std::uint64_t> executed;  // by op; empty when nobody counts
  Recorder* recorder = nullptr;
  cpu::Probe* probe = nullptr;               // probing.h
  std::shared_ptr<const Compiled> compiled;  // compiled.h
  // Where `mark` leads to while the block is compiled. Whoever copies its instructions keeps it, so
  // that no other block is taken for this one.
  std::shared_ptr<const int> identity;
  std::vector<Handler> uncompiled;  // the handlers that compiled code stands in front of
  std::vector<Handler> unprobed;    // the handlers that a probe stands in front of
};

inline const Translated& codeOf(const cpu::Frame& frame) {
  return static_cast<const Translated&>(*frame.code);
}
inline std::uint32_t indexOf(const cpu::Machine& m, const Op* op) {
  return static_cast<std::uint32_t>(op - codeOf(*m.top).ops.data());
}

}  // namespace merker::interpreter
