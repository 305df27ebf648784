// Blocks that a project has as machine code, beside those of its sources.
#pragma once

#include <vector>

#include "block/block.h"
#include "project/project.h"

namespace merker::compilation {

// What sources may call: the blocks of the CPU and, before them, those of containers.
block::Program withMachineCode(const block::Program& library,
                               const std::vector<project::MachineCode>& code);

// Puts the blocks of containers into the program. One that a source declares keeps the names of its
// declaration and takes code and values from the container; P0602 if the two do not fit.
void addMachineCode(const std::vector<project::MachineCode>& code, block::Program& program,
                    Problems& problems);

}  // namespace merker::compilation
