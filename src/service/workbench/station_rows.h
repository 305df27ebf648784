// The stations of a project as the page sees them.
#pragma once

#include "workbench/laboratory.h"
#include "workbench/shared.h"

namespace merker::workbench {

// What stands in merker.toml: stations, subnets, global data, connections, problems.
Json stationRows(const Laboratory& lab, const std::string& shown);
// The event "stations": how they are now.
Json stationsNow(const Laboratory& lab);

}  // namespace merker::workbench
