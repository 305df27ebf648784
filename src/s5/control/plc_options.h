// The PLC's part of the options of a control.
#pragma once

#include "control/cnc.h"

namespace merker::cnc {

// With variant and machine data filled in; without function macros.
sinumerik::Options plcOptions(const Options& options);

}  // namespace merker::cnc
