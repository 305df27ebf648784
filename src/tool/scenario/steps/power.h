// power off, power on, power on unbuffered.
#pragma once

#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct PowerOff : Bare {
  bool perform(StepRun& run) const {
    run.plc().powerOff();
    return true;
  }
};

// Unbuffered: everything that was in RAM is lost.
template <bool buffered>
struct PowerComesBack : Bare {
  bool perform(StepRun& run) const {
    run.plc().powerOn(buffered);
    return true;
  }
};
using PowerOn = PowerComesBack<true>;
using PowerOnUnbuffered = PowerComesBack<false>;

}  // namespace merker::simulator::steps
