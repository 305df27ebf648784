#include "workbench/pace.h"

#include <algorithm>

namespace merker::workbench {
namespace {

// Between two looks at the wall clock while no cycle ends.
constexpr Duration kPortion = Duration::milliseconds(10);
// Time is taken up at the end of a cycle, where values are looked at, unless it lasts too long: in
// virtual time, or behind the end of the slice on the wall. In between it is looked at the wall.
constexpr Duration kLongestCycle = Duration::milliseconds(200);
constexpr Duration kPart = Duration::milliseconds(20);
constexpr std::int64_t kOverdue = 15'000'000;
// What cannot be made good any more is given up.
constexpr std::int64_t kBehind = 200'000'000;
constexpr std::int64_t kMeasure = 500'000'000;

bool runs(const controller::Controller& plc) {
  return plc.mode() == controller::Mode::Run || plc.mode() == controller::Mode::Startup;
}

}  // namespace

// Not beyond what is due: that happens exactly then.
void Pacer::portion(controller::Controller& plc, Instant target, const Schedule& schedule,
                    const std::function<bool()>& tooLong) {
  const Instant due = schedule.next(), latest = std::min(plc.now() + kLongestCycle, due);
  if (!runs(plc)) {
    plc.advanceTo(std::min({plc.now() + kPortion, target, due}));
  } else {
    while (runs(plc) && plc.now() < latest &&
           !plc.advanceToCheckpoint(std::min(plc.now() + kPart, latest)) && !tooLong()) {
    }
  }
  if (plc.now() >= due) schedule.run();
}

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

// False: it has not ended yet.
bool Pacer::stepCycle(controller::Controller& plc, const WallClock& wall, std::int64_t end,
                      const Schedule& schedule) {
  constexpr Duration kLongest = Duration::seconds(60);
  if (!cycle_) cycle_ = Cycle{plc.cycles(), plc.now() + kLongest};
  while (plc.cycles() == cycle_->number) {
    if (!runs(plc) || plc.now() >= cycle_->latest) return steps_ = 1, true;  // no cycle comes
    if (wall() >= end) return false;
    portion(plc, cycle_->latest, schedule, [&] { return wall() >= end; });
  }
  return true;
}

bool Pacer::stepCycles(controller::Controller& plc, const WallClock& wall, std::int64_t end,
                       const Schedule& schedule) {
  for (; steps_ > 0; --steps_) {
    if (wall() >= end || !stepCycle(plc, wall, end, schedule)) return true;
    cycle_.reset();
  }
  return false;
}

bool Pacer::advance(controller::Controller& plc, const WallClock& wall, Duration longest,
                    const Schedule& schedule) {
  const std::int64_t now = wall(), end = now + longest.ns;
  if (pace_.mode == PaceMode::Pause) return running_ = false, stepCycles(plc, wall, end, schedule);
  if (!running_) begin(plc, now);
  measure(plc, now);
  const auto tooLong = [&] { return wall() >= end + kOverdue; };
  if (pace_.mode == PaceMode::Fast) {
    while (wall() < end) portion(plc, plc.now() + kPortion, schedule, tooLong);
    return true;
  }
  const double passed = static_cast<double>(now - wallOrigin_) * pace_.factor;
  const Instant target = origin_ + Duration{static_cast<std::int64_t>(passed)};
  while (plc.now() < target && wall() < end) portion(plc, target, schedule, tooLong);
  const std::int64_t behind = (target - plc.now()).ns;
  if (static_cast<double>(behind) > static_cast<double>(kBehind) * std::max(1.0, pace_.factor)) {
    wallOrigin_ = now;
    origin_ = plc.now();
  }
  return behind > 0;
}

}  // namespace merker::workbench
