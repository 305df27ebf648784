// When the running cycle began, and until when it may last (MD 5).
#pragma once

#include "clock/instant.h"

namespace merker::sinumerik {

class CycleWatch {
 public:
  void begin(Instant now, Duration most) {
    start_ = now;
    allow(now, most);
  }
  void allow(Instant now, Duration most) { end_ = now + most; }  // from now on
  void off() { end_ = Instant::never(); }
  void delay(Duration by) {
    start_ = start_ + by;
    if (end_ != Instant::never()) end_ = end_ + by;
  }
  Instant start() const { return start_; }
  bool exceeded(Instant now) const { return now > end_; }
  // The first instant at which it is exceeded.
  Instant overdue() const { return end_ == Instant::never() ? end_ : end_ + Duration{1}; }

 private:
  Instant start_, end_ = Instant::never();
};

}  // namespace merker::sinumerik
