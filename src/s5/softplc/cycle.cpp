// The cyclic level: images, OB 1, diagnosis (S5-OB-16, -17, S5-SCHED-14 … -16).
#include <algorithm>

#include "base/bcd.h"
#include "softplc/operating_system.h"
#include "softplc/periphery_check.h"

namespace merker::sinumerik {
namespace {

constexpr std::uint8_t kCyclicOb = 1;
constexpr std::uint16_t kReading = 0x000E, kWriting = 0x000A;  // xxx2 of 6154 and 6158

std::uint16_t microseconds(Duration time) { return static_cast<std::uint16_t>(time.ns / 1000); }

// A module that was there at start-up and does not answer any more.
const Module* missingModule(const Surroundings& around) {
  for (const Module& module : around.modules)
    if (!module.fitted && !module.distributed) return &module;
  return nullptr;
}

}  // namespace

void OperatingSystem::beginCycle() {
  requested_ = false;
  const Duration cycleTime = machine_.clock - cycleStart_;
  cycleStart_ = machine_.clock;
  watchdog_ = cycleStart_ + Duration::milliseconds(active_.word(5));
  showDiagnosis(cycleTime);
  times_.cycle = {};
  lookAround();
  if (mode_ != Mode::Run) return;
  readInputs();
  if (mode_ != Mode::Run) return;
  flags_.enterLevel(kCyclicOb, around_);
  forcedFlags.apply(machine_.flags);
  if (options_.macros != nullptr) options_.macros->cycleBegins();
  cycleActive_ = true;
  if (!processor_.begin(kCyclicOb)) endCycle();
}

void OperatingSystem::readInputs() {
  mount(around_.modules, machine_.periphery);
  if (const Module* module = missingModule(around_)) {
    const auto byte = static_cast<std::uint16_t>(toBcd(module->first, 4));
    return raise({Alarm::NoAnswerTransfer, {0, module->output ? kWriting : kReading, byte}});
  }
  machine_.inputs = machine_.periphery.inputs;
  forcedInputs.apply(machine_.inputs);
  const ControlPanel& panel = options_.controlPanel;
  if (!active_.bit(data_bit::kControlPanelToOutputs)) return;
  for (unsigned i = 0; i < panel.bytes; ++i)
    if (panel.input + i < kImageBytes && panel.output + i < kImageBytes)
      machine_.outputs[panel.output + i] = machine_.inputs[panel.input + i];
}

void OperatingSystem::writeOutputs() {
  forcedOutputs.apply(machine_.outputs);
  machine_.periphery.outputs = machine_.outputs;
}

void OperatingSystem::endCycle() {
  cycleActive_ = false;
  flags_.levelComplete(kCyclicOb);
  writeOutputs();
  forcedFlags.apply(machine_.flags);
  showUserAlarms(options_.userAlarms, machine_, alarms_);
  ++cycles_;
  passCheckpoint();
  if (mode_ != Mode::Run) return;
  if (processor_.stpSeen()) return raise({Alarm::Stp, {}});
  runChanges();
}

bool OperatingSystem::runAlone(Instant latest) {
  if (mode_ != Mode::Run || (machine_.levels.empty() && !processor_.begin(kCyclicOb))) return false;
  while (mode_ == Mode::Run && !machine_.levels.empty()) {
    if (machine_.clock >= latest) return false;
    if (!runCompiled(latest) && processor_.step() == Outcome::Trapped) raise(processor_.trap());
  }
  if (mode_ == Mode::Run && processor_.stpSeen()) raise({Alarm::Stp, {}});
  return mode_ == Mode::Run;
}

bool OperatingSystem::runOb1(Duration most) {
  const bool ended = runAlone(machine_.clock + most);
  if (mode_ != Mode::Run) return false;
  schedule_.begin(machine_.clock, schedule_.raster());  // nothing is overdue
  watchdog_ = machine_.clock + Duration::milliseconds(active_.word(5));
  return ended;
}

// The values of the cycle that has just ended, if D 9.15 asks for them.
void OperatingSystem::showDiagnosis(Duration cycleTime) {
  if (!active_.bit(data_bit::kDiagnosis)) return;
  std::uint16_t* const words = diagnosis::word(machine_.blocks, 0);
  const bool complete = diagnosis::word(machine_.blocks, diagnosis::kTrigger) != nullptr;
  if (!complete || (words[diagnosis::kTrigger] & diagnosis::kTriggerBit) == 0) return;
  words[diagnosis::kTrigger] =
      static_cast<std::uint16_t>(words[diagnosis::kTrigger] & ~diagnosis::kTriggerBit);
  words[diagnosis::kCycleTime] = static_cast<std::uint16_t>(cycleTime.ns / 1'000'000);
  words[diagnosis::kRunTime] = microseconds(times_.cycle.cyclic + times_.cycle.alarm);
  words[diagnosis::kCyclicTime] = microseconds(times_.cycle.cyclic);
  words[diagnosis::kAlarmTime] = microseconds(times_.cycle.alarm);
  words[diagnosis::kAlarmRuns] = static_cast<std::uint16_t>(times_.cycle.alarmRuns);
}

}  // namespace merker::sinumerik
