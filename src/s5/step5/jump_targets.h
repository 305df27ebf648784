// Labels for the jumps of machine code.
#pragma once

#include <map>
#include <string>

#include "mc5/block.h"

namespace merker::step5 {

// Those of the source where there are any, else M001 and so on; by word. A jump that leads out of
// its network or into the middle of an instruction has none.
std::map<std::uint32_t, std::string> jumpTargets(const mc5::Program& program,
                                                 const mc5::Block& block);

bool sameNetwork(const mc5::Block& block, std::uint32_t a, std::uint32_t b);

}  // namespace merker::step5
