// Coverage of instructions as coverage of source lines.
#pragma once

#include "block/block.h"
#include "plc/controller.h"

namespace merker::station {

using ExecutedInstructions = std::map<BlockId, std::map<std::uint32_t, std::uint64_t>>;

// The most executed instruction of a line counts; lines of all blocks that have code and a source.
controller::ExecutedLines lineCounts(const block::Program& program,
                                     const ExecutedInstructions& executed);

}  // namespace merker::station
