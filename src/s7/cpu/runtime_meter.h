// A run-time meter counts hours while it is switched on and the CPU is not in STOP (S7-CPU-32,
// S7-SFC-03). It survives power off and memory reset, and stays off after each of them and after
// STOP until SFC 3 switches it on again.
#pragma once

#include <algorithm>
#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

struct RuntimeMeter {
  static constexpr std::int64_t kHour = 3'600'000'000'000;  // ns
  static constexpr std::int64_t kLongest = 32'767;          // hours

  std::int64_t counted = 0;  // ns until `since`
  bool running = false;
  Instant since{};

  std::int64_t total(Instant now) const { return counted + (running ? (now - since).ns : 0); }
  // An overflow leaves the meter at its highest value.
  bool overflow(Instant now) const { return total(now) / kHour > kLongest; }
  std::int64_t hours(Instant now) const { return std::min(total(now) / kHour, kLongest); }

  void set(std::int64_t hours, Instant now) {
    counted = hours * kHour;
    since = now;
  }
  void start(Instant now) {
    if (!running) since = now;
    running = true;
  }
  void stop(Instant now) {
    counted = total(now);
    running = false;
  }
};

}  // namespace merker::cpu
