// The limits of operands on this PLC (S5-LOAD-01, S5-BIT-01, S5-OB-22). A code within the table
// with an operand beyond them is alarm 6102, beyond the timers and counters 6113 (S5-OPC-03).
#pragma once

#include <cstdint>

#include "mc5/instruction.h"

namespace merker::mc5 {

struct Range {
  std::uint32_t lowest = 0, highest = 0;
  std::uint32_t highestBit = 0;
};

// What the operand's number and bit may be.
Range rangeOf(const Instruction& instruction);
bool inRange(const Instruction& instruction);

}  // namespace merker::mc5
