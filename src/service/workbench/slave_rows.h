// What is connected to a station, as racks of the picture: the slaves of an AS-Interface
// (S7-NET-17) and those of PROFIBUS-DP (S7-NET-04 to -06).
#pragma once

#include "io/rack.h"
#include "source/symbol_table.h"
#include "workbench/json.h"

namespace merker::workbench {

// Behind the racks of the station; none if nothing is connected.
void addSlaveRows(Json& racks, const io::Rack& rack, const source::SymbolTable& symbols);

}  // namespace merker::workbench
