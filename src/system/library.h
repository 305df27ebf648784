// What the CPU brings, as the compiler wants it: blocks with an interface and without code.
#pragma once

#include "block/block.h"

namespace merker::system {

// SFC, SFB and the library FCs (IEC and TI-S7 converting blocks) of an S7-300.
block::Program library();

}  // namespace merker::system
