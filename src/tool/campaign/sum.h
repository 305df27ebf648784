// A sum of many numbers that is as exact as one number can be: what each addition loses is kept
// beside it (A. Neumaier, 1974).
#pragma once

#include <cmath>

namespace merker::campaign {

class Sum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  // One that grew beyond all numbers has lost nothing that counts.
  double value() const { return std::isfinite(sum_) ? sum_ + lost_ : sum_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace merker::campaign
