// What blocks take up: load memory holds all of a block, work memory what runs (S7-MEM-03).
#pragma once

#include <cstddef>

#include "block/block.h"

namespace merker::block {

// Bytes of the container; 0 for a UDT.
std::size_t loadMemory(const Block& block);
// Machine code, or the actual values of a data block; an UNLINKED one stays in load memory.
std::size_t workMemory(const Block& block);
std::size_t workMemory(const Program& program);

}  // namespace merker::block
