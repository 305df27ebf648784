// The sampling raster and the alarm level OB 2 (S5-OB-06 … -14, S5-SCHED-10, -19).
#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kAlarmOb = 2;
// Program control of the channels: the NC takes them over in each IPO clock (S5-OB-14).
constexpr unsigned kFastOutputs[] = {90, 99};

}  // namespace

void OperatingSystem::sample() {
  const Instant at = schedule_.nextSample();
  const bool ipo = schedule_.beginsIpoClock(), call = schedule_.callsOb1();
  schedule_.sampled();
  times_.sampled();
  if (times_.alarmWindow() <= alarmLimit()) alarmTimeReported_ = false;
  for (std::size_t i = 0; i < kCells && i <= active_.word(6); ++i)
    machine_.timers[i].count(at, environment_.timeBases);
  if (ipo) ipoClock();
  if (call) {
    requested_ = true;
    times_.lastRaster = times_.raster;
    times_.raster = {};
  }
  if (active_.bit(data_bit::kNoAlarmLevel)) return;
  const Edges edges = alarmInput_.sample(at);
  if (edges.any()) requestAlarmLevel(edges);
}

void OperatingSystem::ipoClock() {
  flags_.ipoClock(betweenCycles());
  for (const unsigned byte : kFastOutputs)
    machine_.periphery.outputs[byte] = machine_.outputs[byte];
}

// A request while OB 2 still runs is a processing delay; as a message it waits for its end
// (S5-OB-12).
void OperatingSystem::requestAlarmLevel(Edges edges) {
  if (!alarmLevelRuns()) return beginAlarmLevel(edges);
  ++fineCode_.delays;
  waitingEdges_.negative = static_cast<std::uint8_t>(waitingEdges_.negative | edges.negative);
  waitingEdges_.positive = static_cast<std::uint8_t>(waitingEdges_.positive | edges.positive);
  raise({Alarm::ProcessingDelay, {kAlarmOb, 0, 0}});
  if (mode_ == Mode::Run) flags_.delayed();
}

void OperatingSystem::beginAlarmLevel(Edges edges) {
  if (machine_.levels.size() >= kInterruptDepth) return raise({Alarm::InterruptStack, {}});
  if (!processor_.begin(kAlarmOb)) return raise({Alarm::MissingBlock, {0, 0, kAlarmOb}});
  flags_.enterLevel(kAlarmOb, around_);
  flags_.showEdges(edges);
  ++times_.cycle.alarmRuns;
}

void OperatingSystem::endAlarmLevel() {
  flags_.showEdges({});
  flags_.levelComplete(kAlarmOb);
  if (!machine_.levels.empty()) flags_.resumeLevel(machine_.level().ob);
  if (processor_.stpSeen() && !cycleActive_) return raise({Alarm::Stp, {}});
  const Edges waiting = waitingEdges_;
  waitingEdges_ = {};
  if (waiting.any()) beginAlarmLevel(waiting);
}

}  // namespace merker::sinumerik
