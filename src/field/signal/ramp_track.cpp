#include "signal/ramp_track.h"

#include <algorithm>

namespace merker::signal {
namespace {

std::int64_t restOf(std::int64_t value, std::int64_t period) {
  const std::int64_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

}  // namespace

// In the direction plus A comes first: 00, 10, 11, 01 (POS-ENC-04).
bool RampTrack::levelIn(std::int64_t pulse) const {
  const std::int64_t quarter = restOf(pulse - marks_.first + 2, 4);
  switch (kind_) {
    case Kind::A:
      return quarter == 1 || quarter == 2;
    case Kind::B:
      return quarter >= 2;
    case Kind::N:
      break;
  }
  const std::int64_t beside = marks_.narrow ? 0 : 1;
  return restOf(pulse - marks_.first + beside, marks_.distance) <= 2 * beside;
}

// The first pulse on the way with another level; `pulse` if there is none.
std::int64_t RampTrack::change(std::int64_t pulse, std::int64_t to) const {
  const int direction = to > pulse ? 1 : -1;
  const bool level = levelIn(pulse);
  std::int64_t at = pulse;
  if (kind_ == Kind::N && !level) {  // the next mark, then its edge
    const std::int64_t edge = marks_.first - direction * (marks_.narrow ? 0 : 1);
    const std::int64_t way = restOf(direction * (edge - pulse), marks_.distance);
    at = pulse + direction * (way == 0 ? marks_.distance : way);
    return direction * (to - at) >= 0 ? at : pulse;
  }
  while (at != to)
    if (levelIn(at += direction) != level) return at;
  return pulse;
}

Instant RampTrack::changeWithin(Instant from, Instant to, std::int64_t lastPulse) const {
  const std::int64_t pulse = ramp_->pulseAt(from);
  const std::int64_t changed = change(pulse, lastPulse);
  if (changed == pulse) return Instant::never();
  return std::min(ramp_->reaches(changed, from), to);
}

Instant RampTrack::next(Instant after) const {
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
Instant RampTrack::last(Instant at) const {
  Instant found = kLongAgo;
  for (Instant t = next(ramp_->start); t <= at && t != Instant::never(); t = next(t)) found = t;
  return found;
}

}  // namespace merker::signal
