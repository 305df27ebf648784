// power off, power on, power on unbuffered.
#pragma once

#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct PowerOff : Bare {
  static constexpr std::string_view kWords = "power off";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    run.plc().powerOff();
    return true;
  }
};

// Unbuffered: everything that was in RAM is lost.
template <bool buffered>
struct PowerComesBack : Bare {
  static constexpr std::string_view kWords = buffered ? "power on" : "power on unbuffered";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const {
    run.plc().powerOn(buffered);
    return true;
  }
};
using PowerOn = PowerComesBack<true>;
using PowerOnUnbuffered = PowerComesBack<false>;

}  // namespace merker::simulator::steps
