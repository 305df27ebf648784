// The SFC and SFB of a CPU as programming devices list them beside the program.
#pragma once

#include "block/block.h"
#include "catalogue/cpu_model.h"

namespace merker::served {

// Blocks with an interface and without code. Built with the first call for a model.
const block::Program& systemBlocks(const CpuModel& model);

}  // namespace merker::served
