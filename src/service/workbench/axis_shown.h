// The positioning axis of the CPU as rows of an answer: what it is, what it shows.
#pragma once

#include "workbench/json.h"
#include "workbench/plc.h"

namespace merker::workbench {

// Null: none is configured.
Json axisRow(const Plc& plc);
// {position: 0, ...}; null: none is configured.
Json axisShown(const Plc& plc);

}  // namespace merker::workbench
