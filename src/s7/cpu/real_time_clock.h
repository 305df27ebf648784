// The CPU's clock: a date and time that runs with the virtual clock (S7-CPU-32).
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "clock/instant.h"

namespace merker::cpu {

// DATE_AND_TIME, 8 BCD bytes (S7-TYPES-18), from and to milliseconds since 1990-01-01.
using DateAndTime = std::array<std::uint8_t, 8>;
DateAndTime toDateAndTime(std::int64_t milliseconds);
// Nothing if a digit or a part (month 13, hour 24 …) is invalid.
std::optional<std::int64_t> fromDateAndTime(const std::uint8_t* bytes);

// The years of DATE_AND_TIME: 1990 to 2089, then 1990 again (docs/compatibility.md).
constexpr std::int64_t kYearsOfClock = 36'525LL * 86'400'000;  // ms

class RealTimeClock {
 public:
  explicit RealTimeClock(std::int64_t millisecondsAtStart) : offset_(millisecondsAtStart) {}
  std::int64_t milliseconds(Instant now) const {
    const std::int64_t shown = running(now) % kYearsOfClock;
    return shown < 0 ? shown + kYearsOfClock : shown;
  }
  void set(std::int64_t milliseconds, Instant now) { offset_ = milliseconds - now.ns / 1'000'000; }
  // The instant at which the clock shows this time, before it begins again.
  Instant when(std::int64_t milliseconds, Instant now) const {
    const std::int64_t begun = running(now) - this->milliseconds(now);
    return Instant{(milliseconds + begun - offset_) * 1'000'000};
  }

 private:
  std::int64_t running(Instant now) const { return offset_ + now.ns / 1'000'000; }

  std::int64_t offset_;  // ms since 1990-01-01 at Instant 0
};

}  // namespace merker::cpu
