// What the CPU brings, as the compiler wants it: blocks with an interface and without code.
#pragma once

#include "block/block.h"
#include "catalogue/block_library.h"
#include "catalogue/cpu_model.h"

namespace merker::system {

// SFC and SFB of a model and the blocks of these libraries.
block::Program library(const CpuModel& model, const Libraries& libraries = standardLibraries());

}  // namespace merker::system
