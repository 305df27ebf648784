// The scan cycle (S7-CYCLE-02): cycle monitoring on, write outputs, read inputs, OB 1, operating
// system, again.
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

// Less than the shortest unit of a timer, 10 ms, whatever instruction ends it.
constexpr Duration kHeld = Duration::milliseconds(5);

}  // namespace

// Held timers are set anew before a unit of their time is over, so that they never show another.
void Cpu::step(Instant limit) {
  if (!timersHeld_) return move(limit);
  move(std::min(limit, machine_.clock + kHeld));
  if (!executes(mode_)) return;
  for (S5Timer& timer : machine_.timers) timer.hold(machine_.clock);
}

void Cpu::move(Instant limit) {
  if (!executes(mode_)) return rest(limit);
  if (mode_ == Mode::Startup && machine_.levels.size() == restOfCycle_)
    enterRun();
  else if (machine_.levels.empty())
    idle(limit);
  else
    runTop(limit);
  if (executes(mode_)) takeEvents();
}

// STOP and HALT: time goes on, the modules with it while there is power.
void Cpu::rest(Instant limit) {
  const Instant next = powered_ ? modules_.next() : Instant::never();
  machine_.clock = std::max(machine_.clock, std::min(limit, next));
  takePeriphery();
}

void Cpu::idle(Instant limit) {
  if (machine_.clock >= nextCycle_) return startCycle();
  machine_.clock = std::max(machine_.clock, std::min({limit, nextCycle_, nextEvent()}));
}

void Cpu::runTop(Instant limit) {
  const Instant until = std::min(limit, nextEvent());
  Level& level = machine_.levels.back();
  if (level.wait == 0) return runInstructions(until);
  const Instant end =  // SFC 47
      std::min(machine_.clock + Duration{level.wait}, std::max(until, machine_.clock));
  level.wait -= (end - machine_.clock).ns;
  machine_.clock = end;
}

void Cpu::runInstructions(Instant until) {
  machine_.horizon = until;
  machine_.levelEnded = false;
  engine_.run(machine_);
  if (mode_ == Mode::Stop) return;
  if (mode_ == Mode::Halt) frozenAt_ = machine_.clock;  // a probe gave its instruction's time back
  if (machine_.levelEnded)
    endLevel();
  else
    machine_.position = engine_.offset(*machine_.top);
}

void Cpu::enterRun() {
  change(Mode::Run);
  ++checkpoints_;
  report(Event::StartupToRun);
  modules_.disableOutputs(false);
  modules_.started();
  nextCycle_ = cycleStart_ = machine_.clock;
  if (!machine_.levels.empty()) monitoring_.begin(machine_.clock, cycleMonitoring());
  if (isHot(lastRestart_)) return;
  for (CyclicInterrupt& cyclic : interrupts_.cyclic) cyclic.begin(machine_.clock);
}

void Cpu::startCycle() {
  if (scan_ == 3) cycleTimes_.add(machine_.clock - cycleStart_);
  cycleStart_ = machine_.clock;
  monitoring_.begin(machine_.clock, cycleMonitoring());
  updateImages();
  if (mode_ != Mode::Run) return;  // an access error without OB 85
  if (!hasOb(1))
    return stopByFault(Event::StopProgramSequence, "OB 1 is not loaded");  // S7-OPEN-39

  StartInformation start = startInformation(0x11, scan_, priorityOf(1), 1, dateAndTime());
  setWord(start, 6, static_cast<std::uint32_t>(cycleTimes_.previous));
  setWord(start, 8, static_cast<std::uint32_t>(cycleTimes_.shortest));
  setWord(start, 10, static_cast<std::uint32_t>(cycleTimes_.longest));
  scan_ = 3;
  startLevel(1, priorityOf(1), start, false);
}

void Cpu::endCycle() {
  ++cycles_;
  ++checkpoints_;
  nextCycle_ = nextCycle();
  reached(CyclePoint::End);
  forces_.apply(machine_.areas.image);
  activateDownload();
  if (observer_) observer_();
}

// The operating system's share, communication, and not before the minimum cycle is over
// (S7-HWCFG-08). With a communication load of p % the rest of the time has to do for the program:
// t * 100 / (100 - p), see docs/compatibility.md, "communication load".
Instant Cpu::nextCycle() const {
  Instant next = machine_.clock + Duration{machine_.model->cycleTime};
  if (communicating_) {
    const std::int64_t load = std::min(parameters_.communicationLoad, 50u);
    next = next + Duration{(next - cycleStart_).ns * load / (100 - load)};
  }
  return std::max(next, cycleStart_ + Duration::milliseconds(parameters_.minimumCycle));
}

bool Cpu::runOb1(Duration most) {
  if (mode_ != Mode::Run) return false;
  if (!hasOb(1)) return false;
  if (machine_.levels.empty()) {
    const StartInformation start = startInformation(0x11, scan_, priorityOf(1), 1, dateAndTime());
    if (!startLevel(1, priorityOf(1), start, false)) return false;
    machine_.levelEnded = false;
  }
  const Instant latest = machine_.clock + most;
  while (mode_ == Mode::Run && !(machine_.levelEnded && machine_.levels.size() == 1)) {
    if (machine_.clock >= latest) return false;
    if (machine_.levelEnded) endLevel();  // of an error OB
    machine_.levelEnded = false;
    machine_.horizon = latest;
    engine_.run(machine_);
  }
  if (mode_ == Mode::Run) endLevel();
  return mode_ == Mode::Run;
}

}  // namespace merker::cpu
