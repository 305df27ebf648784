// A source in the other mnemonics: STEP 7 compiles all sources in one setting.
#pragma once

#include <vector>

#include "exporting/awl_edits.h"

namespace merker::exporting {

// UN E 0.0 becomes AN I 0.0, or back. Nothing for a block that is in these mnemonics.
std::vector<Edit> translation(const step7::BlockSource& block, Mnemonics to);

}  // namespace merker::exporting
