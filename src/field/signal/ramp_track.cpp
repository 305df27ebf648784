#include "signal/ramp_track.h"

#include <algorithm>
#include <cstdlib>

namespace merker::signal {
namespace {

std::int64_t restOf(std::int64_t value, std::int64_t period) {
  const std::int64_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

// In the direction plus A comes first: 00, 10, 11, 01 (POS-ENC-04).
bool levelOf(RampTrackKind kind, std::int64_t pulse, std::int64_t first) {
  const std::int64_t quarter = restOf(pulse - first + 2, 4);
  return kind == RampTrackKind::A ? quarter == 1 || quarter == 2 : quarter >= 2;
}

}  // namespace

bool RampTrack::levelIn(std::int64_t pulse) const {
  if (kind_ != Kind::N) return levelOf(kind_, pulse, marks_.first);
  const std::int64_t beside = marks_.narrow ? 0 : 1;
  return restOf(pulse - marks_.first + beside, marks_.distance) <= 2 * beside;
}

bool LosingTrack::levelIn(std::int64_t pulse) const {
  return levelOf(kind_, gap_.holds(pulse) ? gap_.from : pulse, marks_.first);
}

std::int64_t LosingTrack::change(std::int64_t pulse, std::int64_t to) const {
  const int direction = to > pulse ? 1 : -1;
  const bool level = levelIn(pulse);
  for (std::int64_t at = pulse; at != to;)
    if (levelIn(at += direction) != level) return at;
  return pulse;
}

std::int64_t RampTrack::change(std::int64_t pulse, std::int64_t to) const {
  const int direction = to > pulse ? 1 : -1;
  const bool level = levelIn(pulse);
  if (kind_ == Kind::N && !level) {  // the next mark, there its edge
    const std::int64_t edge = marks_.first - direction * (marks_.narrow ? 0 : 1);
    const std::int64_t way = restOf(direction * (edge - pulse), marks_.distance);
    const std::int64_t at = pulse + direction * way;
    return direction * (to - at) >= 0 ? at : pulse;
  }
  for (std::int64_t at = pulse; at != to;)
    if (levelIn(at += direction) != level) return at;
  return pulse;
}

// A level of A and B lasts for two pulses, and a ramp that does not turn is slowest at one end.
bool RampTrack::neverLasts(Duration length, Instant from, Instant to) const {
  constexpr std::int64_t kTwoPulses = 2 * 1'000'000'000'000;  // thousandths of a pulse, ns
  if (kind_ == Kind::N || ramp()->turns() || from < ramp()->start ||
      to > ramp()->start + ramp()->length)
    return false;
  const std::int64_t slowest = std::min(std::abs(ramp()->speed), std::abs(ramp()->last));
  return slowest > 0 && kTwoPulses / slowest < length.ns;
}

bool RampZone::levelIn(std::int64_t pulse) const {
  const std::int64_t at = revolution_ == 0 ? pulse : restOf(pulse, revolution_);
  return at >= from_ && at < to_;
}

// The nearest border on the way; the first pulse behind it, seen in the direction.
std::int64_t RampZone::change(std::int64_t pulse, std::int64_t to) const {
  const int direction = to > pulse ? 1 : -1;
  std::int64_t nearest = 0;
  for (const std::int64_t border : {from_, to_}) {
    std::int64_t way = direction * ((direction > 0 ? border : border - 1) - pulse);
    if (revolution_ != 0) way = restOf(way, revolution_);
    if (way > 0 && (nearest == 0 || way < nearest)) nearest = way;
  }
  const std::int64_t at = pulse + direction * nearest;
  return nearest != 0 && direction * (to - at) >= 0 ? at : pulse;
}

}  // namespace merker::signal
