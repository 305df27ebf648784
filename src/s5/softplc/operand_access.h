// Operands in memory: images, flags, data of the open block.
#pragma once

#include <cstdint>
#include <optional>

#include "mc5/operand.h"
#include "softplc/machine.h"

namespace merker::sinumerik {

// The value, bits not used are 0. Data beyond the block are the next words of the segment, beyond
// the segment 0 (S5-DB-15). Not for the periphery, timers and counters.
std::uint32_t read(Machine& m, const mc5::Operand& operand);
// False: no data block is open, or the word lies beyond it (OP-04).
bool write(Machine& m, const mc5::Operand& operand, std::uint32_t value);

}  // namespace merker::sinumerik
