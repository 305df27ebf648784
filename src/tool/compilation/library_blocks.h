// Blocks of SIMATIC_NET_CP that STEP 7 has copied into a program (docs/compatibility.md,
// "Libraries"): their code speaks with the memory of a real CP.
#pragma once

#include "base/problem.h"
#include "block/block.h"

namespace merker::compilation {

// Those of `library` run in their place: P0526.
void preferLibraryBlocks(const block::Program& library, block::Program& program,
                         Problems& problems);

}  // namespace merker::compilation
