// Comment blocks OK, PK, SK, FK, DK: titles of networks and comments of lines.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"
#include "mc5/block.h"
#include "s5d/layout.h"

namespace merker::s5d {

// Adds titles and comments to the block, whose code is there already, as the blocks that it calls.
// What belongs to lines that it does not have is left out; gives how many.
std::size_t readComments(Bytes comments, const mc5::Program& program, Encoding codePage,
                         mc5::Block& block);

// The comment block with its header; empty if there is nothing to say.
std::vector<std::uint8_t> writeComments(const mc5::Program& program, const mc5::Block& block,
                                        Encoding codePage);

}  // namespace merker::s5d
