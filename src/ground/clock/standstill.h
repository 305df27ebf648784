// Loops that go from instant to instant must come to an end. One that is asked for the same instant
// again and again would hang; it gives up after so many times, and the CPU then stops.
#pragma once

#include "clock/instant.h"

namespace merker {

class Standstill {
 public:
  // More than any number of things that really happen at one instant.
  explicit Standstill(unsigned most = 256) : most_(most) {}
  // False: the loop came to `to`, or before it, too often.
  bool moves(Instant to) {
    times_ = to <= at_ ? times_ + 1 : 0;
    at_ = to;
    return times_ < most_;
  }

 private:
  unsigned most_, times_ = 0;
  Instant at_{INT64_MIN};
};

}  // namespace merker
