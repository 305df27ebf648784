// Instants at even distances that need not be whole nanoseconds: 60 kHz have a period of 16666 2/3
// ns. Each instant is rounded down by itself, so nothing adds up: 60 000 periods are exactly 1 s.
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::signal {

// A length of time as a fraction of nanoseconds.
struct Period {
  std::int64_t numerator = 0, denominator = 1;
  bool operator==(const Period&) const = default;
};

struct Grid {
  Instant start;
  Period period;
  // Start + i periods + offset / denominator.
  Instant at(std::int64_t i, std::int64_t offset = 0) const;
  // The last i with at(i) <= t; negative before the start.
  std::int64_t index(Instant t) const;
};

}  // namespace merker::signal
