// The machine code of a STEP 5 block as regions of intermediate code.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "icode/region.h"
#include "mc5/instruction.h"

namespace merker::translate5 {

// The processor that the code is for.
struct Target {
  mc5::Variant variant = mc5::Variant::Acop;
  std::uint32_t lastTimer = 15;
  // Words of timers and counters, the low byte first, in Space::Instance: timer n at
  // n * timerBytes, counter n at counters + n * counterBytes.
  std::uint32_t timerBytes = 2, counters = 0, counterBytes = 2;
};

// What stands for an instruction with a formal operand; its own time comes on top.
struct Substitute {
  mc5::Decoded decoded;
  mc5::Times extra;
};
using Substitutes = std::map<std::uint32_t, Substitute>;  // by word

// Calls that lead into other blocks without the processor: number of the site (jit/blocks.h) by the
// word of the call.
using Sites = std::map<std::uint32_t, std::uint32_t>;

// Data words are in Space::Data, their low byte first. Registers: VKE is Rlo, ERAB is Er, ANZ1 and
// ANZ0 are Cc1 and Cc0. Instructions are numbered by their word in the block. `apart`: by word,
// those that stay with the processor; empty: none. Without `sites` no
// way leads out of the block: calls, block ends, A DB are the processor's.
std::vector<icode::Region> translate(std::span<const std::uint16_t> code, const Target& target,
                                     const std::vector<bool>& apart = {},
                                     const Substitutes& substitutes = {},
                                     const Sites* sites = nullptr);

}  // namespace merker::translate5
