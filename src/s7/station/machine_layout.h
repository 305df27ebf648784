// cpu::Machine as compiled code sees it.
#pragma once

#include "catalogue/cpu_model.h"
#include "jit/layout.h"

namespace merker::station {

jit::Layout layoutOf(const CpuModel& model);

}  // namespace merker::station
