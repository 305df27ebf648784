// Cycle monitoring (S7-CYCLE-06): exceeded once it asks for OB 80, twice in one cycle for STOP.
#pragma once

#include "clock/instant.h"

namespace merker::cpu {

class CycleMonitoring {
 public:
  // A cycle begins, or SFC 43 triggers again.
  void begin(Instant now, Duration limit) { *this = {now + limit, limit, false}; }
  void off() { *this = {}; }
  Instant deadline() const { return deadline_; }
  bool exceeded(Instant now) const { return now >= deadline_; }
  // Goes on for the same time; false if it had been exceeded in this cycle before.
  bool extend() {
    const bool first = !warned_;
    warned_ = true;
    deadline_ = deadline_ + limit_;
    return first;
  }
  void delay(Duration by) {
    if (deadline_ != Instant::never()) deadline_ = deadline_ + by;
  }

  CycleMonitoring() = default;

 private:
  CycleMonitoring(Instant deadline, Duration limit, bool warned)
      : deadline_(deadline), limit_(limit), warned_(warned) {}

  Instant deadline_ = Instant::never();
  Duration limit_{};
  bool warned_ = false;
};

}  // namespace merker::cpu
