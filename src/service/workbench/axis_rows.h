// The pages of the sub-module 2.5 as rows of an answer: basic parameters, drive, axis, encoder,
// diagnosis (technology manual 3.2.2; POS-OVW-17, POS-PARAM-31).
#pragma once

#include "io/configuration.h"
#include "workbench/json.h"

namespace merker::workbench {

// Behind the rows that every module has: its name, its addresses.
void addAxisRows(const io::Parameters& parameters, Json& list);

}  // namespace merker::workbench
