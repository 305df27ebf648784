// The body of an OB, PB, SB or FB: lines to machine code.
#pragma once

#include <map>

#include "mc5/block.h"
#include "step5/block_source.h"
#include "step5/declaration.h"

namespace merker::step5 {

// Declarations of all FBs that can be called, by number.
using FunctionBlocks = std::map<std::uint16_t, const mc5::Block*>;

// `block` has its head and declaration; words, lines, networks, labels and checks come here.
void compileCode(const BlockSource& source, std::size_t firstLine, const FunctionBlocks& known,
                 bool checks, mc5::Block& block, Problems& problems);

}  // namespace merker::step5
