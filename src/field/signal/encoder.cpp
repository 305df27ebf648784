#include "signal/encoder.h"

#include <algorithm>

namespace merker::signal {
namespace {

constexpr std::int64_t kNanosecondsTimesMillihertz = 1'000'000'000'000;
constexpr std::int64_t kQuarters = 4;  // of a period

std::int64_t magnitude(std::int64_t frequency) { return frequency < 0 ? -frequency : frequency; }

Grid gridOf(const Motion& motion) {
  return {motion.start, {kNanosecondsTimesMillihertz, kQuarters * magnitude(motion.frequency)}};
}

std::int64_t stepsOf(const Motion& motion, Instant t) {
  if (motion.frequency == 0 || t <= motion.start) return 0;
  const std::int64_t steps = gridOf(motion).index(t);
  return motion.quarters == 0 ? steps : std::min(steps, motion.quarters);
}

}  // namespace

std::int64_t Motion::positionAt(Instant t) const {
  const std::int64_t steps = stepsOf(*this, t);
  return frequency < 0 ? position - steps : position + steps;
}

std::int64_t EncoderTrack::steps(Instant t) const { return stepsOf(motion_, t); }
Instant EncoderTrack::stepAt(std::int64_t number) const { return gridOf(motion_).at(number); }

bool EncoderTrack::levelAt(std::int64_t steps) const {
  const std::int64_t position =
      motion_.frequency < 0 ? motion_.position - steps : motion_.position + steps;
  const auto quarter = static_cast<unsigned>(position & 3);
  return track_ == Track::A ? quarter == 1 || quarter == 2 : quarter >= 2;
}

// A track changes at every second step.
Instant EncoderTrack::next(Instant after) const {
  if (stands()) return Instant::never();
  const std::int64_t done = steps(after);
  for (std::int64_t i = done + 1; i <= done + 2 && i <= mostSteps(); ++i)
    if (levelAt(i) != levelAt(i - 1)) return stepAt(i);
  return Instant::never();
}

Instant EncoderTrack::last(Instant at) const {
  for (std::int64_t i = steps(at), least = std::max<std::int64_t>(i - 1, 1); i >= least; --i)
    if (levelAt(i) != levelAt(i - 1)) return stepAt(i);
  return kLongAgo;
}

Rhythm EncoderTrack::rhythm(Instant from) const {
  if (stands() || from < motion_.start || steps(from) >= mostSteps()) return {};
  const Instant end = motion_.quarters == 0 ? Instant::never() : stepAt(motion_.quarters);
  return {{kNanosecondsTimesMillihertz, magnitude(motion_.frequency)}, end};
}

Instant EncoderTrack::later(Instant edge, std::int64_t periods) const {
  return stepAt(steps(edge) + kQuarters * periods);
}

}  // namespace merker::signal
