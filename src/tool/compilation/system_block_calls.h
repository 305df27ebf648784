// Calls of the SFBs of the technological functions that the manual forbids and no CPU refuses.
#pragma once

#include "base/problem.h"
#include "block/block.h"

namespace merker::compilation {

// P0523: SFB 60 to 65 with two instance data blocks (manual 6.4; PTP-SFBG-01). P0524: one of SFB 44
// to 49 and 60 to 65 in two priority classes (manual 3.3, 4.3, 5.4, 6.4; POS-OVW-20, CNT-IF47-13,
// PTP-SFBG-03). The start-up (OB 100 to 102) is over before OB 1 begins.
void noteSystemBlockCalls(const block::Program& program, Problems& problems);

}  // namespace merker::compilation
