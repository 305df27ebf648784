// Dead time: what went in comes out that much later.
#pragma once

#include <cmath>
#include <deque>

#include "clock/instant.h"

namespace merker::plant {

class Delay {
 public:
  explicit Delay(double seconds)
      : length_{static_cast<std::int64_t>(std::llround(seconds * 1e9))} {}

  // The input that begins at `now`; what comes out then. 0 before anything has passed through.
  double operator()(Instant now, double input) {
    if (length_.ns == 0) return input;
    samples_.push_back({now, input});
    while (samples_.size() > 1 && samples_[1].from + length_ <= now) samples_.pop_front();
    return samples_.front().from + length_ <= now ? samples_.front().input : 0;
  }

 private:
  struct Sample {
    Instant from;
    double input;
  };
  Duration length_;
  std::deque<Sample> samples_;
};

inline double seconds(Instant from, Instant to) {
  return static_cast<double>((to - from).ns) / 1e9;
}

}  // namespace merker::plant
