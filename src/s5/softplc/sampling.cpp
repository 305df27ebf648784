// The sampling raster: timers, IPO clock, calls of OB 1, the alarm level; limits of run times.
#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kCyclicOb = 1;
// Program control of the channels: the NC takes them over in each IPO clock (S5-OB-14).
constexpr unsigned kFastOutputs[] = {90, 99};

}  // namespace

void OperatingSystem::sample() {
  const Instant at = schedule_.nextSample();
  const bool ipo = schedule_.beginsIpoClock(), call = schedule_.callsOb1();
  schedule_.sampled();
  times_.sampled();
  alarmLevel_.sampled(alarmLimit());
  for (std::size_t i = 0; i < kCells && i <= active_.word(6); ++i)
    machine_.timers[i].count(at, environment_.timeBases);
  if (ipo) ipoClock();
  if (call) {
    requested_ = true;
    times_.lastRaster = times_.raster;
    times_.raster = {};
  }
  if (!active_.bit(data_bit::kNoAlarmLevel)) sampleAlarms(at);
}

void OperatingSystem::ipoClock() {
  flags_.ipoClock(betweenCycles());
  for (const unsigned byte : kFastOutputs)
    machine_.periphery.outputs[byte] = machine_.outputs[byte];
}

void OperatingSystem::sampleAlarms(Instant at) {
  const auto trap = alarmLevel_.sample(at);
  const bool delay = trap && trap->alarm == Alarm::ProcessingDelay;
  if (delay) record_.delayed();
  raise(trap);
  if (delay && mode() == Mode::Run) flags_.delayed();
}

void OperatingSystem::endAlarmLevel() {
  alarmLevel_.end();
  if (processor_.stpSeen() && !cycleActive_) return raise(Trap{Alarm::Stp, {}});
  raise(alarmLevel_.beginWaiting());
}

// Load limits (S5-SCHED-05, -10), judged when a level ends: a loop without end is a matter of the
// watchdog, and an OB 2 that is requested again one of the processing delay.
void OperatingSystem::judgeRunTime(std::uint8_t ob) {
  const std::int64_t cyclicLimit = schedule_.raster().call.ns * active_.word(1) / 100;
  if (ob == kCyclicOb && !active_.bit(data_bit::kChopping) && times_.cycle.cyclic.ns > cyclicLimit)
    raise(Trap{Alarm::CyclicRunTime, {}});
  if (ob == kAlarmOb && alarmLevel_.exceeds(alarmLimit())) raise(Trap{Alarm::AlarmRunTime, {}});
}

}  // namespace merker::sinumerik
