// The block container: the form in which a block lies in load memory, on a memory card and on the
// wire (docs/formats/block.md; MC7 section 8).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "block/block.h"

namespace merker::block {

// CRC-16, polynomial 9003h, over type byte, length of the code or the actual values, and these.
std::uint16_t checksum(const Block& block);

// The container of a block, time stamps 0. Its length is what `merker list` shows as load memory.
// Empty for a UDT, which exists only in the project, and if a part is longer than its 16-bit length
// can say.
std::vector<std::uint8_t> writeContainer(const Block& block);

// The block in a container: header, code or actual values, interface, networks. Errors: not a
// container (P0601), lengths that do not fit (P0602), checksum wrong (P0603), interface that cannot
// be read (P0604). Names, comments and line numbers are not in a container; variables get the names
// that STEP 7 gives them then: IN0, OUT0, STAT3.
Result<Block> readContainer(std::span<const std::uint8_t> bytes, const Position& at);

}  // namespace merker::block
