// Pre-headers: the formats of a data block's words (DV), the labels of a function block (FV).
#pragma once

#include <vector>

#include "mc5/block.h"
#include "s5d/layout.h"

namespace merker::s5d {

// Without one every word is a KH. False if it is damaged; the block keeps what could be read.
bool readFormats(Bytes preHeader, mc5::Block& block);
std::vector<std::uint8_t> writeFormats(const mc5::Block& block);

// Names the targets of jumps. Where labels lie is not known from STEP 5 (docs/compatibility.md); a
// pre-header of another form changes nothing.
void readLabels(Bytes preHeader, mc5::Block& block);
// Empty for a block without labels.
std::vector<std::uint8_t> writeLabels(const mc5::Block& block);

}  // namespace merker::s5d
