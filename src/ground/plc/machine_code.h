// Machine code of the host instead of the reference engine; the results are the same.
#pragma once

#include <cstddef>

#include "plc/capability.h"

namespace merker::controller {

class MachineCode : public Capability {
 public:
  static constexpr std::string_view kName = "machine code";

  // From now on; the program goes on where it stands. False: there is no compiler for this
  // processor.
  virtual bool setCompiled(bool on) = 0;
  // The same by itself as soon as it pays (base/payback.h). `elsewhere`: not in this thread, which
  // has a cycle to keep.
  virtual void compileWhenItPays(bool elsewhere) = 0;
  virtual bool compiled() const = 0;
  // What the program has no machine code for yet gets it now, not before its first instruction.
  virtual void translateNow() = 0;
  virtual std::size_t compiledBytes() const = 0;
};

}  // namespace merker::controller
