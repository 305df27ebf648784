// The state of a CPU as its CP shows it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cpu/leds.h"
#include "monitor/monitor.h"

namespace merker::itcp {

struct CpuFacts {
  struct Led {
    std::string_view name, colour;  // of HTML
    cpu::Light light;
  };
  struct Entry {
    std::string clock, event, text;
  };
  static constexpr std::size_t kMostEntries = 10;

  std::string model, orderNumber;
  std::string mode, stopReason;  // empty unless it is in STOP
  std::string clock;
  std::uint64_t cycles = 0;
  std::int32_t lastCycle = 0, shortestCycle = 0, longestCycle = 0;  // ms
  std::vector<Led> leds;                                            // none: the PLC has no such
  std::vector<Entry> entries;  // of the diagnostic buffer, the newest first
};

// In the thread of the PLC.
CpuFacts factsOf(const monitor::Monitor& monitor);
// "on", "off", "2 Hz"
std::string_view nameOf(cpu::Light light);

}  // namespace merker::itcp
