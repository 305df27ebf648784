// B stack and I stack of a SINUMERIK in HALT and STOP.
#pragma once

#include "monitor/control_target.h"
#include "monitor/stacks.h"

namespace merker::monitor {

// In HALT and STOP; empty while the program runs, and when no block was running.
Stacks controlStacks(const sinumerik::Plc& plc, const ControlTarget& target);

}  // namespace merker::monitor
