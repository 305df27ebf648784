// Compiled code in front of the handlers: where it begins, one handler goes through it and comes
// back in front of the instruction that is to be done next.
#pragma once

#include <cstddef>
#include <memory>

#include "interpreter/translated.h"

namespace merker::interpreter {

class Compiled {
 public:
  virtual ~Compiled() = default;
  virtual bool begins(std::size_t instruction) const = 0;
  // By instruction, for compiled code of other blocks that comes or goes back here.
  virtual const void* const* entries() const = 0;
  // Clock and count of instructions as if each had been executed alone; the op to go on with, in
  // the block that is then the top one. Both unchanged if the compiled code could do nothing here.
  virtual const Op* run(cpu::Machine& m, std::size_t instruction) const = 0;
};

// From now on this block runs compiled, except while a probe looks at it; null: not any more.
void setCompiled(Translated& code, std::shared_ptr<const Compiled> compiled);
// Puts the handlers in front or takes them away; the compiled code stays with the block.
void attachCompiled(Translated& code);
void detachCompiled(Translated& code);

}  // namespace merker::interpreter
