// Configured connections of the station that is shown: of S7 communication (S7-NETPRO-08) and of
// its CP 343-1 (S7-SFB-10), whether or not somebody carries them.
#pragma once

#include "workbench/communication_view.h"

namespace merker::workbench {

struct Shared;

Json configuredRows(const Shared& shared, const S7Outside& outside);

}  // namespace merker::workbench
