// Jobs of the technology blocks: one read or written value, by number (CNT-JOB).
#pragma once

#include <cstdint>

namespace merker::technology {

struct JobResult {
  std::uint16_t error = 0;  // as JOB_STAT shows it; 0: done
  bool reads = false;
  std::int32_t value = 0;  // what was read
};

// A value with its limits and the numbers that say it is too small or too large.
struct JobRange {
  std::int64_t low, high;
  std::uint16_t tooSmall;  // too large: one more
  std::uint16_t check(std::int64_t value) const {
    if (value < low) return tooSmall;
    return value > high ? static_cast<std::uint16_t>(tooSmall + 1) : std::uint16_t{0};
  }
};

}  // namespace merker::technology
