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

void portion(controller::Controller& plc, Instant target) {
  const bool runs = plc.mode() == controller::Mode::Run || plc.mode() == controller::Mode::Startup;
  if (runs)
    plc.advanceToCheckpoint(plc.now() + kLongestCycle);
  else
    plc.advanceTo(std::min(plc.now() + kPortion, target));
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

bool Pacer::stepCycles(controller::Controller& plc, const WallClock& wall, std::int64_t end) {
  for (; steps_ > 0; --steps_) {
    if (wall() >= end) return true;
    const std::uint64_t before = plc.cycles();
    plc.advanceCycles(1);
    if (plc.cycles() == before) steps_ = 1;  // STOP or HALT: no cycle comes
  }
  return false;
}

bool Pacer::advance(controller::Controller& plc, const WallClock& wall, Duration longest) {
  const std::int64_t now = wall(), end = now + longest.ns;
  if (pace_.mode == PaceMode::Pause) return running_ = false, stepCycles(plc, wall, end);
  if (!running_) begin(plc, now);
  measure(plc, now);
  if (pace_.mode == PaceMode::Fast) {
    while (wall() < end) portion(plc, plc.now() + kPortion);
    return true;
  }
  const double passed = static_cast<double>(now - wallOrigin_) * pace_.factor;
  const Instant target = origin_ + Duration{static_cast<std::int64_t>(passed)};
  while (plc.now() < target && wall() < end) portion(plc, target);
  const std::int64_t behind = (target - plc.now()).ns;
  if (static_cast<double>(behind) > static_cast<double>(kBehind) * std::max(1.0, pace_.factor)) {
    wallOrigin_ = now;
    origin_ = plc.now();
  }
  return behind > 0;
}

}  // namespace merker::workbench
