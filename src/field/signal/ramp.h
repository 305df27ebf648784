// A movement whose speed changes evenly over a time: the position at any instant and the instant of
// any position, exactly. Positions are millionths of a pulse, speeds thousandths of a pulse per
// second, so that a ramp of whole milliseconds ends on whole numbers (POS-PLANT-02).
#pragma once

#include <algorithm>
#include <cstdint>

#include "clock/instant.h"

namespace merker::signal {

constexpr std::int64_t kPulse = 1'000'000;  // in units of a position

// The pulse that a position lies in; it is entered where the position becomes a whole number.
constexpr std::int64_t pulseOf(std::int64_t position) {
  const std::int64_t pulse = position / kPulse;
  return position % kPulse < 0 ? pulse - 1 : pulse;
}

struct Ramp {
  Instant start;
  Duration length = Duration::milliseconds(4);
  std::int64_t position = 0;         // at the start
  std::int64_t speed = 0, last = 0;  // at the start and at the end
  // With a play the ramp is that of a load behind it: `position` and `speed` are those of the
  // motor, `load` is the load at the start, from 0 up to `play` beyond the motor (POS-PLANT-22).
  std::int64_t play = 0, load = 0;

  // Rounded down; from the end on the axis stands there.
  std::int64_t at(Instant t) const;
  std::int64_t end() const { return at(start + length); }
  std::int64_t pulseAt(Instant t) const { return pulseOf(at(t)); }
  bool turns() const { return (speed < 0 && last > 0) || (speed > 0 && last < 0); }
  // Where and when it turns, rounded down.
  std::int64_t turningPoint() const;
  // Where the load is when the motor has come to a position by this ramp.
  std::int64_t loadAt(std::int64_t motor) const { return std::clamp(load, motor, motor + play); }
  Instant turningTime() const;
  // When it is in this pulse first, from an instant on; never() if it does not come there.
  Instant reaches(std::int64_t pulse, Instant from) const;
  Instant reaches(std::int64_t pulse) const { return reaches(pulse, start); }

 private:
  std::int64_t motorAt(Instant t) const;
  Instant first(std::int64_t pulse, Instant from, Instant to) const;
};

}  // namespace merker::signal
