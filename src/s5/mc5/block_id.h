// The name of a block of STEP 5 as both families name blocks, and back.
#pragma once

#include <optional>
#include <string>

#include "address/block_id.h"
#include "mc5/block.h"

namespace merker::mc5 {

merker::BlockId neutralId(BlockId id);
// Nothing if STEP 5 has no block of this kind.
std::optional<BlockId> step5Id(merker::BlockId id);
std::string toString(BlockId id);  // "PB 5"

}  // namespace merker::mc5
