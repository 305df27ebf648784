// What a CPU keeps when another hardware configuration is loaded into it in STOP
// (docs/compatibility.md).
#pragma once

#include "workbench/plc.h"

namespace merker::workbench {

// `fresh`: the same station with the new configuration, just built. Another CPU model has nothing
// to keep, nor has a machine without single blocks.
void inherit(Plc& fresh, Plc& before);

}  // namespace merker::workbench
