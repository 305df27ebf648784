// Run times of the interpreter, measured per level: they do not contain what interrupted it
// (S5-SCHED-12).
#pragma once

#include "clock/instant.h"

namespace merker::sinumerik {

struct CycleTimes {
  Duration cyclic, alarm;  // of OB 1 and of OB 2
  unsigned alarmRuns = 0;
};

struct RunTimes {
  CycleTimes cycle;      // since the last update of the input image
  Duration alarmWindow;  // OB 2 in these 4 samplings (S5-SCHED-10)
  Duration third;        // OB 1 in this third of the raster (S5-SCHED-06)
  Duration raster;       // both in this raster
  Duration lastRaster;   // and in the one before

  void charge(bool alarmLevel, Duration time) {
    raster = raster + time;
    if (alarmLevel) {
      cycle.alarm = cycle.alarm + time;
      alarmWindow = alarmWindow + time;
    } else {
      cycle.cyclic = cycle.cyclic + time;
      third = third + time;
    }
  }
};

}  // namespace merker::sinumerik
