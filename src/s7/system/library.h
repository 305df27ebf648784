// What the CPU brings, as the compiler wants it: blocks with an interface and without code.
#pragma once

#include "block/block.h"
#include "catalogue/cpu_model.h"

namespace merker::system {

// SFC, SFB and the library FCs (IEC and TI-S7 converting blocks) of a model.
block::Program library(const CpuModel& model);

}  // namespace merker::system
