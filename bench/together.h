// Many stations in one process, on two threads.
#pragma once

#include <vector>

#include "station/station.h"

namespace merker::bench {

// Half of them on each thread; all of them get on by this time, in slices.
void advanceTogether(std::vector<station::Station>& stations, Duration by);

}  // namespace merker::bench
