#include "signal/ramp.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

std::int64_t floored(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient - (quotient * b != a && (a < 0) != (b < 0) ? 1 : 0);
}

// Whether everything below fits into 64 bits: a step of an axis that accelerates by no more than
// 125 000 000 pulses/s^2.
bool isGentle(const Ramp& ramp) {
  constexpr std::int64_t kLongest = 4'000'000, kMost = 500'000, kFastest = 1'000'000'000;
  return ramp.length.ns <= kLongest && std::abs(ramp.last - ramp.speed) <= kMost &&
         std::abs(ramp.speed) <= kFastest;
}

// v t and what is left of it together with (w - v) t^2 / 2T.
std::int64_t gentleWay(const Ramp& ramp, std::int64_t passed) {
  const std::int64_t even = ramp.speed * passed, whole = floored(even, kScale);
  if (ramp.last == ramp.speed) return whole;
  const std::int64_t twice = 2 * ramp.length.ns;
  const std::int64_t rest =
      twice * (even - whole * kScale) + (ramp.last - ramp.speed) * passed * passed;
  return whole + floored(rest, twice * kScale);
}

}  // namespace

// The motor takes the load along where it meets it; before a turn it may have pushed it away.
std::int64_t Ramp::at(Instant t) const {
  const std::int64_t motor = motorAt(t);
  if (play == 0) return motor;
  const bool turned = turns() && t > turningTime();
  return std::clamp(turned ? loadAt(turningPoint()) : load, motor, motor + play);
}

// About when the motor comes to a position that lies ahead of it before it turns: ns from the
// start.
double timeOf(const Ramp& ramp, double position) {
  const double way = (position - static_cast<double>(ramp.position)) * kScale;
  const auto v = static_cast<double>(ramp.speed);
  const double change = 2 * static_cast<double>(ramp.last - ramp.speed) * way;
  const double root = std::sqrt(std::max(v * v + change / static_cast<double>(ramp.length.ns), 0.));
  const double sum = v + (ramp.speed + ramp.last < 0 ? -root : root);
  return sum == 0 ? 0 : 2 * way / sum;
}

// x = x0 + v t + (w - v) t^2 / 2T
std::int64_t Ramp::motorAt(Instant t) const {
  const std::int64_t passed = std::clamp<std::int64_t>((t - start).ns, 0, length.ns);
  if (passed == 0 || (speed == 0 && last == 0)) return position;
  if (isGentle(*this)) return position + gentleWay(*this, passed);
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

// On a part of the ramp that goes one way: by halves, of the few ns around the calculated time if
// it is among them.
Instant Ramp::first(std::int64_t pulse, Instant from, Instant to) const {
  const bool rises = at(from) < at(to);
  const auto there = [&](Instant t) { return rises ? pulseAt(t) >= pulse : pulseAt(t) <= pulse; };
  if (from >= to || there(from) || !there(to)) return Instant::never();
  const double edge = static_cast<double>(rises ? pulse : pulse + 1) * kPulse;
  const double about = std::clamp(timeOf(*this, edge), 0., static_cast<double>(length.ns));
  const Instant near = start + Duration{static_cast<std::int64_t>(about)};
  constexpr Duration kBeside{2};
  if (near - kBeside > from && !there(near - kBeside)) from = near - kBeside;
  if (near + kBeside < to && there(near + kBeside)) to = near + kBeside;
  while ((to - from).ns > 1) {
    const Instant middle = from + Duration{(to - from).ns / 2};
    (there(middle) ? to : from) = middle;
  }
  return to;
}

}  // namespace merker::signal
