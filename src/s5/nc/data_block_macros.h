// FB 11 EINR-DB and FB 60 BLOCK-TR.
#pragma once

#include <span>

#include "nc/macro_error.h"

namespace merker::nc {

using Parameters = std::span<const std::uint16_t>;

// DBAN, DWNR: data blocks of zeros (S5-FM-07 … -11).
Error createDataBlocks(sinumerik::Machine& machine, Parameters parameters);
// DBQZ, DWQ, DZ/A: up to 128 words from block to block (S5-FM-19 … -22).
Error transferBlock(sinumerik::Machine& machine, Parameters parameters);

}  // namespace merker::nc
