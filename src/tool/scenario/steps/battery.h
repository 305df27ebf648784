// battery low, battery good: OB 81; on a SINUMERIK M 24.1.
#pragma once

#include "scenario/steps/bare.h"
#include "station/station.h"

namespace merker::simulator::steps {

template <bool low>
struct Battery : Bare {
  bool perform(StepRun& run) const {
    if (run.station() == nullptr) return run.plc().batteryFails(low) || run.onlyForStation();
    run.station()->setBattery(low);
    return true;
  }
};
using BatteryLow = Battery<true>;
using BatteryGood = Battery<false>;

}  // namespace merker::simulator::steps
