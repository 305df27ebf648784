// How long a value that moves evenly leaves the switches along its way as they are.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace merker::plant {

inline constexpr double kForever = std::numeric_limits<double>::infinity();
// s: on either side of a switch a value may have come to it or not, for sums of floating point.
// These are some 10^-9 s beside it at most: an hour of steps of 1 ms, each rounded by 10^-16.
inline constexpr double kUnsure = 0.0001;

// Until a value that changes by `speed` each second comes to `place`. So slow that floating point
// decides its way: nothing is known.
inline double secondsTo(double place, double value, double speed) {
  constexpr double kSlowest = 1e-6;  // of the value, each second
  if (speed == 0) return kForever;
  if (std::abs(speed) < kSlowest * std::max(std::abs(place), std::abs(value))) return 0;
  const double seconds = (place - value) / speed;
  return seconds < -kUnsure ? kForever : std::max(seconds, 0.0);
}

// Between two ends at which it stands still, past switches.
inline double secondsTo(std::initializer_list<double> places, double value, double speed,
                        double low, double high) {
  const bool stands = (speed <= 0 && value <= low) || (speed >= 0 && value >= high);
  double seconds = kForever;
  if (!stands)
    for (const double place : places) seconds = std::min(seconds, secondsTo(place, value, speed));
  return seconds;
}

}  // namespace merker::plant
