// Blocks with errors: what compiles of them is not what is written, so their networks come from the
// text.
#pragma once

#include <map>
#include <string>

#include "compilation/build.h"
#include "diagram/diagram.h"

namespace merker::diagram {

// By name, "FC 1".
std::map<std::string, BlockDiagram> faultyBlocks(const compilation::Build& build);

}  // namespace merker::diagram
