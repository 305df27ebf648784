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

class RealTimeClock {
 public:
  explicit RealTimeClock(std::int64_t millisecondsAtStart) : offset_(millisecondsAtStart) {}
  std::int64_t milliseconds(Instant now) const { return offset_ + now.ns / 1'000'000; }
  void set(std::int64_t milliseconds, Instant now) { offset_ = milliseconds - now.ns / 1'000'000; }
  // The instant at which the clock shows this time.
  Instant when(std::int64_t milliseconds) const {
    return Instant{(milliseconds - offset_) * 1'000'000};
  }

 private:
  std::int64_t offset_;  // ms since 1990-01-01 at Instant 0
};

}  // namespace merker::cpu
