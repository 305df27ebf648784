// One lag: what of the way to its input a value goes within a time, 1 - exp(-dt / T).
#pragma once

#include <cmath>

namespace merker::plant {

class Lag {
 public:
  explicit Lag(double timeConstant) : timeConstant_(timeConstant) {}

  // Steps are mostly as long as the one before.
  double share(double seconds) {
    if (seconds != seconds_) {
      seconds_ = seconds;
      share_ = 1 - std::exp(-seconds / timeConstant_);
    }
    return share_;
  }

 private:
  double timeConstant_;
  double seconds_ = 0, share_ = 0;
};

}  // namespace merker::plant
