// System data blocks of a CPU: its configuration as blocks, as programming devices list and fetch
// them (docs/formats/block.md, "System data blocks"). Passwords are not in them.
#pragma once

#include "block/block.h"
#include "catalogue/cpu_parameters.h"
#include "io/configuration.h"

namespace merker::served {

// SDB 0 the CPU, SDB 1 its modules if it has a configuration, SDB 2 what the CPU has without one.
block::Program systemData(const CpuModel& model, const CpuParameters& parameters,
                          const io::Configuration* hardware);

}  // namespace merker::served
