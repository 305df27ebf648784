// The mounting rules of the S7-300 (course 3.4).
#pragma once

#include "io/configuration.h"

namespace merker::io {

// Whether the module can stand where it stands, for itself (S7-HW-12, -17).
bool checkPlace(const Module& module, const CpuModel& model, Problems& problems);
// All modules together: gaps, interface modules, current, channels.
void checkMounting(const Configuration& configuration, Problems& problems);

}  // namespace merker::io
