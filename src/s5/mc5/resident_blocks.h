// Declarations of the resident function macros: what a programmer reads of them (S5-FM-01, -02).
#pragma once

#include <span>

#include "mc5/block.h"

namespace merker::mc5 {

// FB 11, 56, 57, 58, 60, 61, 62, 65, 66, 190: number, name and parameters, no code.
std::span<const Block> residentBlocks();
const Block* findResident(std::uint16_t functionBlock);  // null if there is none

}  // namespace merker::mc5
