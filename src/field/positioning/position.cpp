#include "positioning/position.h"

#include <algorithm>
#include <cstdlib>

namespace merker::positioning {
namespace {

// Switched off for encoders with other numbers of pulses (POS-PARAM-26).
bool watchesMarks(const io::AxisChannel& parameters) {
  const std::int64_t pulses = std::int64_t{parameters.increments} * 4;
  return parameters.monitors.missingPulse && (pulses % 10 == 0 || pulses % 16 == 0);
}

}  // namespace

Position::Position(const io::AxisChannel& parameters)
    : sign_(parameters.inverted ? -1 : 1), watchesMarks_(watchesMarks(parameters)) {}

void Position::reset(std::int64_t coordinate) {
  offset_ = coordinate - count_;
  direction_ = 1;
  markKnown_ = false;
  betweenMarks_ = 0;
  beginCycle();
}

void Position::move(std::int64_t pulses) {
  if (pulses == 0) return;
  count_ += sign_ * pulses;
  direction_ = (pulses > 0) == (sign_ > 0) ? 1 : -1;
  low_ = std::min(low_, count_);
  high_ = std::max(high_, count_);
}

// The distance is learned, not taken from the parameters: wrong ones are not noticed. A mark that
// is passed again after a reversal counts nothing (POS-MON-03).
bool Position::zeroMark() {
  const std::int64_t distance = std::abs(count_ - lastMark_);
  const bool first = !markKnown_;
  markKnown_ = true;
  lastMark_ = count_;
  if (!watchesMarks_ || first || distance == 0) return true;
  if (betweenMarks_ == 0) betweenMarks_ = distance;
  return distance == betweenMarks_;
}

std::int64_t shown(std::int64_t coordinate, const io::AxisChannel& parameters) {
  if (!parameters.rotary) return coordinate;
  const std::int64_t rest = coordinate % parameters.rotaryEnd;
  return rest < 0 ? rest + parameters.rotaryEnd : rest;
}

}  // namespace merker::positioning
