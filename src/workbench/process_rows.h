// Plants as rows of an answer, and their values as they are now.
#pragma once

#include "source/symbol_table.h"
#include "station/station.h"
#include "workbench/json.h"

namespace merker::workbench {

Json plantRows(const station::Station& station, const source::SymbolTable& symbols);
// {name: {value: number}}
Json plantValues(const plant::Plants& plants);
// Of the signals that are stuck, what they are stuck at: {name: {signal: number}}
Json plantFaults(const plant::Plants& plants);

}  // namespace merker::workbench
