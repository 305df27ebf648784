#include "signal/pulse_train.h"

#include <algorithm>

namespace merker::signal {
namespace {

constexpr std::int64_t kNanosecondsTimesMillihertz = 1'000'000'000'000;

// splitmix64 (Steele, Lea, Flood 2014): any place of the sequence without those before it.
std::uint64_t random(std::uint64_t seed, std::int64_t place) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15u * (static_cast<std::uint64_t>(place) + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

Pulses pulsesOf(std::int64_t millihertz, std::uint32_t duty, Instant start) {
  Pulses pulses{.start = start, .period = {kNanosecondsTimesMillihertz, millihertz}};
  pulses.high = pulses.period.numerator / 1000 * duty;
  return pulses;
}

std::uint32_t mostJitter(const Pulses& pulses) {
  const std::int64_t shorter = std::min(pulses.high, pulses.period.numerator - pulses.high);
  const std::int64_t thousandths = shorter / (pulses.period.numerator / 1000);
  return thousandths < 2 ? 0 : static_cast<std::uint32_t>((thousandths - 1) / 2);
}

std::int64_t PulseTrain::displacement(std::int64_t number) const {
  if (pulses_.jitter == 0) return 0;
  const std::int64_t most = pulses_.period.numerator / pulses_.period.denominator *
                            static_cast<std::int64_t>(pulses_.jitter) / 1000;
  const auto width = static_cast<std::uint64_t>(2 * most + 1);
  return static_cast<std::int64_t>(random(pulses_.seed, number) % width) - most;
}

Instant PulseTrain::edge(std::int64_t number) const {
  const Instant even = grid_.at(number / 2, number % 2 != 0 ? pulses_.high : 0);
  return std::max(even + Duration{displacement(number)}, pulses_.start);
}

// How many edges there were. The guess by the grid is off by two at most.
std::int64_t PulseTrain::edgesUntil(Instant t) const {
  if (t < pulses_.start) return 0;
  std::int64_t count = std::max<std::int64_t>(2 * grid_.index(t) - 1, 0);
  const std::int64_t most = pulses_.count == 0 ? INT64_MAX : 2 * pulses_.count;
  while (count < most && edge(count) <= t) ++count;
  return std::min(count, most);
}

Instant PulseTrain::next(Instant after) const {
  const std::int64_t number = edgesUntil(after);
  return pulses_.count != 0 && number >= 2 * pulses_.count ? Instant::never() : edge(number);
}

Instant PulseTrain::last(Instant at) const {
  const std::int64_t count = edgesUntil(at);
  return count == 0 ? kLongAgo : edge(count - 1);
}

Rhythm PulseTrain::rhythm(Instant from) const {
  if (pulses_.jitter != 0 || from < pulses_.start) return {};
  const Instant end = pulses_.count == 0 ? Instant::never() : edge(2 * pulses_.count - 1);
  if (from >= end) return {};
  return {pulses_.period, end};
}

Instant PulseTrain::later(Instant at, std::int64_t periods) const {
  return edge(edgesUntil(at) - 1 + 2 * periods);
}

}  // namespace merker::signal
