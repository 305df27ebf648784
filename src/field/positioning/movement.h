// Actual-value monitoring: during a run the axis must move on in its direction within the
// monitoring time (POS-MON-08 to -10).
#pragma once

#include "positioning/motion.h"

namespace merker::positioning {

class Movement {
 public:
  explicit Movement(const io::AxisChannel& parameters)
      : most_(parameters.monitors.movement ? cyclesOf(parameters.monitoringTime) : 0) {}

  void reset() { direction_ = 0; }  // a run starts
  // A cycle of a run; true: it has not moved for too long.
  bool stands(int direction, std::int64_t farthest) {
    const bool first = direction != direction_;
    if (first || direction * (farthest - farthest_) > 0) {
      direction_ = direction;
      farthest_ = farthest;
      cycles_ = 0;
      return false;
    }
    return most_ > 0 && ++cycles_ >= most_;
  }

 private:
  std::int64_t most_;  // cycles; 0: not monitored
  int direction_ = 0;
  std::int64_t farthest_ = 0;
  std::int64_t cycles_ = 0;
};

}  // namespace merker::positioning
