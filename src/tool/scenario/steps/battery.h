// battery low, battery good: OB 81; on a SINUMERIK M 24.1.
#pragma once

#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

template <bool low>
struct Battery : Bare {
  static constexpr std::string_view kWords = low ? "battery low" : "battery good";
  static constexpr bool kPartner = true;

  bool perform(StepRun& run) const { return run.plc().batteryFails(low) || run.lacks("battery"); }
};
using BatteryLow = Battery<true>;
using BatteryGood = Battery<false>;

}  // namespace merker::simulator::steps
