// Programs written in AWL, compiled without their checks: blocks with checks stay with the
// interpreter.
#pragma once

#include <string>

#include "block/block.h"
#include "catalogue/cpu_model.h"

namespace merker::differential {

// Empty if there are errors.
block::Program compiled(const std::string& path, const CpuModel& model);
block::Program compiledText(const std::string& text, const CpuModel& model);
// system_calls.awl
const block::Program& systemCalls();

}  // namespace merker::differential
