// A seam: machine code of this computer in front of the processor. Whoever puts the PLC together
// may fill it; the processor remains the reference and does what the engine leaves.
#pragma once

#include "base/payback.h"
#include "softplc/processor.h"

namespace merker::sinumerik {

class Engine {
 public:
  virtual ~Engine() = default;

  bool on = false;
  Payback payback;  // it comes on by itself

  // All code blocks as they lie in segment 5. `apart`: by its words, instructions that somebody
  // looks at and that therefore stay with the processor.
  virtual void compile(Machine& machine, const Environment& environment,
                       const std::vector<bool>& apart) = 0;
  // From the next instruction of the machine on, none of which begins at the horizon or later:
  // registers, memory, clock and step counter as the processor would leave them. Answers how many
  // were executed; 0: this one is for the processor.
  virtual std::uint64_t run(Machine& machine, Instant horizon) = 0;
};

}  // namespace merker::sinumerik
