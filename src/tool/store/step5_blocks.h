// The blocks of a STEP 5 program in the form in which a memory card holds them
// (docs/formats/card.md).
#pragma once

#include <optional>

#include "block/block.h"
#include "mc5/block.h"

namespace merker::cnc {

block::Program toCard(const mc5::Program& program);
// Nothing if these are no blocks of STEP 5. Names of parameters, lines and formats are not on a
// card.
std::optional<mc5::Program> fromCard(const block::Program& blocks);

}  // namespace merker::cnc
