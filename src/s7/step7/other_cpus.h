// System functions of CPUs that Merker does not have, an S7-400 and others with a bus: their
// interfaces, so that programs for them compile. Nothing executes them; who calls one is warned.
#pragma once

#include "block/block.h"

namespace merker::step7 {

// Null if it is none of them.
const block::Block* functionOfOtherCpu(BlockId id);

}  // namespace merker::step7
