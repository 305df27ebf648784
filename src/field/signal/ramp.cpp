#include "signal/ramp.h"

#include <algorithm>

namespace merker::signal {
namespace {

__extension__ typedef __int128 Wide;

// Of mp/s times ns, in millionths of a pulse.
constexpr std::int64_t kScale = 1'000'000;

std::int64_t roundedDown(Wide a, Wide b) {
  const Wide quotient = a / b;
  const bool below = quotient * b != a && (a < 0) != (b < 0);
  return static_cast<std::int64_t>(quotient - (below ? 1 : 0));
}

}  // namespace

// x = x0 + v t + (w - v) t^2 / 2T
std::int64_t Ramp::at(Instant t) const {
  const std::int64_t passed = std::clamp<std::int64_t>((t - start).ns, 0, length.ns);
  if (passed == 0 || (speed == 0 && last == 0)) return position;
  const Wide twice = 2 * Wide{length.ns};
  const Wide way = twice * speed * passed + Wide{last - speed} * passed * passed;
  return position + roundedDown(way, twice * kScale);
}

Instant Ramp::turningTime() const {
  return start + Duration{roundedDown(-Wide{speed} * length.ns, last - speed)};
}

// x0 - v^2 T / 2 (w - v)
std::int64_t Ramp::turningPoint() const {
  return position +
         roundedDown(-Wide{speed} * speed * length.ns, Wide{2 * kScale} * (last - speed));
}

Instant Ramp::reaches(std::int64_t pulse, Instant from) const {
  const Instant to = start + length;
  if (pulseAt(from) == pulse) return from;
  if (!turns() || from >= turningTime()) return first(pulse, from, to);
  const Instant turning = turningTime();
  return std::min(first(pulse, from, turning), first(pulse, turning, to));
}

// On a part of the ramp that goes one way: by halves.
Instant Ramp::first(std::int64_t pulse, Instant from, Instant to) const {
  const bool rises = at(from) < at(to);
  const auto there = [&](Instant t) { return rises ? pulseAt(t) >= pulse : pulseAt(t) <= pulse; };
  if (from >= to || there(from) || !there(to)) return Instant::never();
  while ((to - from).ns > 1) {
    const Instant middle = from + Duration{(to - from).ns / 2};
    (there(middle) ? to : from) = middle;
  }
  return to;
}

}  // namespace merker::signal
