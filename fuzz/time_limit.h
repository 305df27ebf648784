// Limits of processor time that hold in any build: other programs do not count; sanitizers and the
// fuzzer's own marks cost a multiple.
#pragma once

#include <time.h>

#include <algorithm>

#include "harness.h"

namespace merker::fuzz {

// Seconds of the processor that this thread has used.
inline double used() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// How much slower this program is than one that is built for users, on a usual machine: there the
// reference takes `usual` seconds.
template <typename Reference>
double slowness(double usual, Reference&& reference) {
  const double begin = used();
  reference();
  return std::max(1.0, (used() - begin) / usual);
}

template <typename Do>
auto within(double seconds, const char* property, Do&& work) {
  const double begin = used();
  auto result = work();
  require(used() - begin < seconds, property);
  return result;
}

}  // namespace merker::fuzz
