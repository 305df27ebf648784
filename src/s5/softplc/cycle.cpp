// The cyclic level: images, OB 1, diagnosis (S5-OB-16, -17, S5-SCHED-14 … -16).
#include "softplc/operating_system.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kCyclicOb = 1;

}  // namespace

void OperatingSystem::beginCycle() {
  requested_ = false;
  const Duration cycleTime = machine_.clock - watch_.start();
  watch_.begin(machine_.clock, cycleLimit());
  if (active_.bit(data_bit::kDiagnosis))
    diagnosis::showTimes(machine_.blocks, cycleTime, times_.cycle);
  times_.cycle = {};
  lookAround();
  if (mode() != Mode::Run || !readInputs()) return;
  flags_.enterLevel(kCyclicOb, around_);
  images_.forceFlags();
  if (options_.macros != nullptr) options_.macros->cycleBegins();
  cyclePoints_.reached(controller::CyclePoint::Begin);
  cycleActive_ = true;
  if (!processor_.begin(kCyclicOb)) endCycle();
}

// False: the PLC has stopped.
bool OperatingSystem::readInputs() {
  if (const auto trap = images_.read(around_.modules)) {
    raise(trap);
    return mode() == Mode::Run;
  }
  if (active_.bit(data_bit::kControlPanelToOutputs)) images_.copyPanel(options_.controlPanel);
  return true;
}

void OperatingSystem::endCycle() {
  cycleActive_ = false;
  cyclePoints_.reached(controller::CyclePoint::End);
  flags_.levelComplete(kCyclicOb);
  images_.write();
  images_.forceFlags();
  showUserAlarms(options_.userAlarms, machine_, record_.alarms());
  ++cycles_;
  cycleEnded_ = machine_.clock;
  passCheckpoint();
  if (mode() != Mode::Run) return;
  if (processor_.stpSeen()) return raise(Trap{Alarm::Stp, {}});
  changes_.carryOut();
}

bool OperatingSystem::runAlone(Instant latest) {
  if (mode() != Mode::Run || (machine_.levels.empty() && !processor_.begin(kCyclicOb)))
    return false;
  while (mode() == Mode::Run && !machine_.levels.empty()) {
    if (machine_.clock >= latest) return false;
    if (!runCompiled(latest) && processor_.step() == Outcome::Trapped) raise(processor_.trap());
  }
  if (mode() == Mode::Run && processor_.stpSeen()) raise(Trap{Alarm::Stp, {}});
  return mode() == Mode::Run;
}

bool OperatingSystem::runOb1(Duration most) {
  const bool ended = runAlone(machine_.clock + most);
  if (mode() != Mode::Run) return false;
  schedule_.begin(machine_.clock, schedule_.raster());  // nothing is overdue
  watch_.allow(machine_.clock, cycleLimit());
  return ended;
}

void OperatingSystem::passCheckpoint() {
  ++checkpoints_;
  if (observer_) observer_();
}

}  // namespace merker::sinumerik
