// Plants as rows of an answer, and their values as they are now.
#pragma once

#include "source/symbol_table.h"
#include "station/station.h"
#include "workbench/json.h"

namespace merker::workbench {

struct Shared;
struct Browser;

Json plantRows(const plant::Field& field, const source::SymbolTable& symbols);
// What a plant can be.
Json plantKindRows();
// {name: {value: number}}
Json plantValues(const plant::Plants& plants);
// Of the signals that are stuck, what they are stuck at: {name: {signal: number}}
Json plantFaults(const plant::Plants& plants);

// Lets go what a browser that has gone held down.
void releaseHeld(Shared& shared, const Browser& browser);

}  // namespace merker::workbench
