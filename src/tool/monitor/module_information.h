// What "module information" of a CPU shows: state, cycle times, memory, clock.
#pragma once

#include <optional>
#include <string>

#include "station/station.h"

namespace merker::monitor {

// The cycle of a SINUMERIK begins every so often (0 before the first start); how long its program
// ran in the last one.
struct CallRaster {
  Duration length, runTime;
  unsigned loadPerMille = 0;  // share of STEP 5 (S5-SCHED-07)
};

// What the machine does not have is 0.
struct ModuleInformation {
  std::string model;
  station::Mode mode = station::Mode::Stop;
  bool fault = false;      // STOP through a fault
  std::string stopReason;  // in STOP
  Instant time;
  std::string clock;  // empty: none. DT#2005-09-01-08:00:00.000
  std::uint64_t cycles = 0, instructions = 0;
  std::int32_t lastCycle = 0, shortestCycle = 0, longestCycle = 0;  // ms
  std::uint32_t cycleMonitoring = 0;                                // ms
  std::optional<CallRaster> raster;                                 // instead of the cycle times
  std::uint32_t loadMemory = 0;                                     // bytes that the blocks take
  std::uint32_t workMemory = 0, workMemoryUsed = 0;                 // bytes
  std::uint32_t localData = 0;                                      // bytes per priority class
  std::uint32_t inputs = 0, outputs = 0, flags = 0, timers = 0, counters = 0;
  std::size_t blocks = 0;
};

ModuleInformation moduleInformation(const station::Station& station);
std::string_view name(station::Mode mode);  // "RUN"
// DATE_AND_TIME of milliseconds since 1990-01-01: "2005-09-01 08:00:00.000"
std::string clockText(std::int64_t milliseconds);

}  // namespace merker::monitor
