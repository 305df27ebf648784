#include "workbench/pace.h"

#include <algorithm>

namespace merker::workbench {
namespace {

// Between two looks at the wall clock while no cycle ends.
constexpr Duration kPortion = Duration::milliseconds(10);
// Time is taken up at the end of a cycle, where values are looked at, unless it lasts too long.
constexpr Duration kLongestCycle = Duration::milliseconds(200);
// What cannot be made good any more is given up.
constexpr std::int64_t kBehind = 200'000'000;
constexpr std::int64_t kMeasure = 500'000'000;

bool runs(const controller::Controller& plc) {
  return plc.mode() == controller::Mode::Run || plc.mode() == controller::Mode::Startup;
}

// Not beyond what is due: that happens exactly then.
void portion(controller::Controller& plc, Instant target, const Schedule& schedule) {
  const Instant due = schedule.next();
  if (runs(plc))
    plc.advanceToCheckpoint(std::min(plc.now() + kLongestCycle, due));
  else
    plc.advanceTo(std::min({plc.now() + kPortion, target, due}));
  if (plc.now() >= due) schedule.run();
}

void oneCycle(controller::Controller& plc, const Schedule& schedule) {
  const std::uint64_t before = plc.cycles();
  const Instant latest = plc.now() + Duration::seconds(60);
  while (schedule.next() != Instant::never() && plc.cycles() == before && runs(plc) &&
         plc.now() < latest)
    portion(plc, latest, schedule);
  if (plc.cycles() == before) plc.advanceCycles(1);
}

}  // namespace

void Pacer::begin(const controller::Controller& plc, std::int64_t now) {
  running_ = true;
  wallOrigin_ = measuredAt_ = now;
  origin_ = measured_ = plc.now();
}

void Pacer::measure(const controller::Controller& plc, std::int64_t now) {
  if (now - measuredAt_ < kMeasure) return;
  reached_ =
      static_cast<double>((plc.now() - measured_).ns) / static_cast<double>(now - measuredAt_);
  measuredAt_ = now;
  measured_ = plc.now();
}

bool Pacer::stepCycles(controller::Controller& plc, const WallClock& wall, std::int64_t end,
                       const Schedule& schedule) {
  for (; steps_ > 0; --steps_) {
    if (wall() >= end) return true;
    const std::uint64_t before = plc.cycles();
    oneCycle(plc, schedule);
    if (plc.cycles() == before) steps_ = 1;  // STOP or HALT: no cycle comes
  }
  return false;
}

bool Pacer::advance(controller::Controller& plc, const WallClock& wall, Duration longest,
                    const Schedule& schedule) {
  const std::int64_t now = wall(), end = now + longest.ns;
  if (pace_.mode == PaceMode::Pause) return running_ = false, stepCycles(plc, wall, end, schedule);
  if (!running_) begin(plc, now);
  measure(plc, now);
  if (pace_.mode == PaceMode::Fast) {
    while (wall() < end) portion(plc, plc.now() + kPortion, schedule);
    return true;
  }
  const double passed = static_cast<double>(now - wallOrigin_) * pace_.factor;
  const Instant target = origin_ + Duration{static_cast<std::int64_t>(passed)};
  while (plc.now() < target && wall() < end) portion(plc, target, schedule);
  const std::int64_t behind = (target - plc.now()).ns;
  if (static_cast<double>(behind) > static_cast<double>(kBehind) * std::max(1.0, pace_.factor)) {
    wallOrigin_ = now;
    origin_ = plc.now();
  }
  return behind > 0;
}

}  // namespace merker::workbench
