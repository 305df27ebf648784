// The segment table (ADD) of a block container: lengths of the networks and places of the jumps, in
// little-endian words (MC7 section 8).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "block/block.h"

namespace merker::block {

std::vector<std::uint8_t> writeSegmentTable(const Block& block);
// Fills networks and jumps; a table that contradicts the code is left out, since nothing depends on
// it.
void readSegmentTable(std::span<const std::uint8_t> bytes, Block& block);

}  // namespace merker::block
