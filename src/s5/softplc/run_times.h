// Run times of the interpreter, measured per level: they do not contain what interrupted it
// (S5-SCHED-12).
#pragma once

#include <array>

#include "clock/instant.h"

namespace merker::sinumerik {

struct CycleTimes {
  Duration cyclic, alarm;  // of OB 1 and of OB 2
  unsigned alarmRuns = 0;
  bool operator==(const CycleTimes&) const = default;
};

struct RunTimes {
  CycleTimes cycle;                        // since the last update of the input image
  std::array<Duration, 4> alarmSamples{};  // OB 2 in this sampling time and the three before it
  Duration third;                          // OB 1 in this third of the raster (S5-SCHED-06)
  Duration raster;                         // both in this raster
  Duration lastRaster;                     // and in the one before
  bool operator==(const RunTimes&) const = default;

  // OB 2 in any interval of 4 sampling times (1.3.4, S5-SCHED-10).
  Duration alarmWindow() const {
    Duration sum{};
    for (const Duration one : alarmSamples) sum = sum + one;
    return sum;
  }
  void sampled() {
    for (std::size_t i = alarmSamples.size() - 1; i > 0; --i) alarmSamples[i] = alarmSamples[i - 1];
    alarmSamples[0] = {};
  }

  void charge(bool alarmLevel, Duration time) {
    raster = raster + time;
    if (alarmLevel) {
      cycle.alarm = cycle.alarm + time;
      alarmSamples[0] = alarmSamples[0] + time;
    } else {
      cycle.cyclic = cycle.cyclic + time;
      third = third + time;
    }
  }
};

}  // namespace merker::sinumerik
