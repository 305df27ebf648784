// Data words of a DB: "0: KH = 1F00;", "DW 1 KF +5", "KS = 'TEXT'" (3.1, S5-DB-02, -04).
#pragma once

#include "mc5/block.h"
#include "step5/block_source.h"

namespace merker::step5 {

void compileData(const BlockSource& source, mc5::Block& block, Problems& problems);

}  // namespace merker::step5
