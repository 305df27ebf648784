#include "signal/ramp_signal.h"

#include <algorithm>

namespace merker::signal {

Instant RampSignal::changeWithin(Instant from, Instant to, std::int64_t lastPulse) const {
  const std::int64_t pulse = ramp_->pulseAt(from);
  const std::int64_t changed = change(pulse, lastPulse);
  if (changed == pulse) return Instant::never();
  return std::min(ramp_->reaches(changed, from), to);
}

Instant RampSignal::next(Instant after) const {
  const Instant end = ramp_->start + ramp_->length;
  const Instant from = std::max(after, ramp_->start);
  if (from >= end) return Instant::never();
  const std::int64_t lastPulse = pulseOf(ramp_->end());
  if (!ramp_->turns() || from >= ramp_->turningTime()) return changeWithin(from, end, lastPulse);
  const Instant turning = ramp_->turningTime();
  const Instant before = changeWithin(from, turning, ramp_->pulseAt(turning));
  return before != Instant::never() ? before : changeWithin(turning, end, lastPulse);
}

// On a part of the ramp that goes one way: back to where the level of its end began.
Instant RampSignal::lastWithin(Instant from, Instant to) const {
  const std::int64_t first = ramp_->pulseAt(from), pulse = ramp_->pulseAt(to);
  const std::int64_t before = first == pulse ? pulse : change(pulse, first);
  if (before == pulse) return kLongAgo;
  return ramp_->reaches(pulse > first ? before + 1 : before - 1, from);
}

Instant RampSignal::last(Instant at) const {
  if (at < ramp_->start) return kLongAgo;
  const Instant to = std::min(at, ramp_->start + ramp_->length);
  if (!ramp_->turns() || to <= ramp_->turningTime()) return lastWithin(ramp_->start, to);
  const Instant behind = lastWithin(ramp_->turningTime(), to);
  return behind != kLongAgo ? behind : lastWithin(ramp_->start, ramp_->turningTime());
}

}  // namespace merker::signal
