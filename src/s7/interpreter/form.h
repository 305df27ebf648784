// The shapes of operands for which handlers differ. Direct operands have forms of their own, so
// that they are reached with one offset and at most one comparison; everything else goes through
// operand_access.h.
#pragma once

#include <cstdint>

#include "address/area.h"

namespace merker::interpreter {

enum class Form : std::uint8_t {
  None,
  Image,     // E, A, M inside their limits
  Data,      // DBX …
  Instance,  // DIX …
  Local,     // L
  Memory,    // everything else in memory: periphery, V, indirect, parameters, beyond the limits
  Timer,
  Counter,
  StatusBit,
  Constant,
  Other,  // status word, address register, DBNO …, P##
  Count
};

}  // namespace merker::interpreter
