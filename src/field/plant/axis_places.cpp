#include "plant/axis_places.h"

#include <algorithm>

namespace merker::plant {
namespace {

std::int64_t modulo(std::int64_t value, std::int64_t period) {
  const std::int64_t rest = value % period;
  return rest < 0 ? rest + period : rest;
}

// Whether it lies on the way, and nearer than `best`.
void consider(std::int64_t place, std::int64_t pulse, std::int64_t& best) {
  if (best > pulse ? place > pulse && place < best : place < pulse && place > best) best = place;
}

// A place that comes again each `period` pulses: the next one on the way.
std::int64_t following(std::int64_t place, std::int64_t period, std::int64_t pulse, bool forward) {
  if (period == 0) return place;
  const std::int64_t behind = modulo(pulse - place, period);
  if (forward) return pulse - behind + period;
  return pulse - (behind == 0 ? period : behind);
}

}  // namespace

bool Zone::holds(std::int64_t pulse, std::int64_t revolution) const {
  const std::int64_t at = revolution == 0 ? pulse : modulo(pulse, revolution);
  return at >= from && at < to;
}

bool AxisPlaces::isMark(std::int64_t pulse) const {
  return modulo(pulse - firstMark, betweenMarks) == 0;
}

std::int64_t AxisPlaces::loadAt(std::int64_t load, std::int64_t pulse) const {
  return std::clamp(load, pulse, pulse + backlash);
}

std::int64_t AxisPlaces::next(std::int64_t pulse, std::int64_t to) const {
  const bool forward = to > pulse;
  std::int64_t best = to;
  consider(following(firstMark, betweenMarks, pulse, forward), pulse, best);
  for (const Zone& zone : {reference, workpiece})
    for (const std::int64_t border : {zone.from, zone.to}) {
      const std::int64_t place =
          forward ? border : border - 1 - backlash;  // the first pulse behind it
      consider(following(place, revolution, pulse, forward), pulse, best);
    }
  return best;
}

}  // namespace merker::plant
