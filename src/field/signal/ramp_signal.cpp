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

// The one before: found forward, a ramp is short.
Instant RampSignal::last(Instant at) const {
  Instant found = kLongAgo;
  for (Instant t = next(ramp_->start); t <= at && t != Instant::never(); t = next(t)) found = t;
  return found;
}

}  // namespace merker::signal
