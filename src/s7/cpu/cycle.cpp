// The scan cycle (S7-CYCLE-02): cycle monitoring on, write outputs, read inputs, OB 1, operating
// system, again.
#include <algorithm>

#include "cpu/cpu.h"
#include "cpu/levels.h"

namespace merker::cpu {
namespace {

// Less than the shortest unit of a timer, 10 ms, whatever instruction ends it.
constexpr Duration kHeld = Duration::milliseconds(5);

}  // namespace

// Held timers are set anew before a unit of their time is over, so that they never show another.
void Cpu::step(Instant limit) {
  if (!timersHeld_) return move(limit);
  move(std::min(limit, machine_.clock + kHeld));
  if (!state_.executing()) return;
  for (S5Timer& timer : machine_.timers) timer.hold(machine_.clock);
}

void Cpu::move(Instant limit) {
  if (!state_.executing()) return rest(limit);
  if (mode() == Mode::Startup && machine_.levels.size() == startup_.interrupted())
    enterRun();
  else if (machine_.levels.empty())
    idle(limit);
  else
    runTop(limit);
  if (state_.executing()) takeEvents();
}

// STOP and HALT: time goes on, the modules with it while there is power.
void Cpu::rest(Instant limit) {
  const Instant next = powered_ ? modules_.next() : Instant::never();
  machine_.clock = std::max(machine_.clock, std::min(limit, next));
  takePeriphery();
}

void Cpu::idle(Instant limit) {
  if (machine_.clock >= cycle_.next()) return startCycle();
  machine_.clock = std::max(machine_.clock, std::min({limit, cycle_.next(), nextEvent()}));
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
  if (mode() == Mode::Stop) return;
  if (mode() == Mode::Halt) state_.stillHalted();  // a probe gave its instruction's time back
  if (machine_.levelEnded)
    endTopLevel();
  else
    machine_.position = engine_.offset(*machine_.top);
}

void Cpu::endTopLevel() {
  const Level ended = endLevel(machine_);
  if (ended.ob == 40) moduleEvents_.hardwareInterruptEnded(ended.start);
  if (ended.ob == 1 && mode() == Mode::Run) endCycle();
}

void Cpu::enterRun() {
  state_.run();
  log_.report(Event::StartupToRun);
  modules_.disableOutputs(false);
  modules_.started();
  cycle_.enterRun(machine_.clock, !machine_.levels.empty());
  if (!isHot(startup_.how())) interrupts_.beginCyclic();
}

void Cpu::startCycle() {
  cycle_.begin(machine_.clock);
  updateImages();
  if (mode() != Mode::Run) return;  // an access error without OB 85
  if (!hasOb(machine_, 1))
    return stopByFault(Event::StopProgramSequence, "OB 1 is not loaded");  // S7-OPEN-39
  startLevel(machine_, 1, priorityOf(1), cycle_.startOfOb1(log_.dateAndTime()), false);
}

void Cpu::endCycle() {
  cycle_.end(machine_.clock);
  cycleEnded_ = machine_.clock;
  lastOutlook_ = machine_.outlook;
  machine_.outlook.begin();
  cyclePoints_.reached(CyclePoint::End);
  forces_.apply(machine_.areas.image);
  activateDownload();
  if (observer_) observer_();
}

bool Cpu::runOb1(Duration most) {
  if (mode() != Mode::Run) return false;
  if (!hasOb(machine_, 1)) return false;
  if (machine_.levels.empty()) {
    const StartInformation start =
        startInformation(0x11, cycle_.scan(), priorityOf(1), 1, log_.dateAndTime());
    if (!startLevel(machine_, 1, priorityOf(1), start, false)) return false;
    machine_.levelEnded = false;
  }
  const Instant latest = machine_.clock + most;
  while (mode() == Mode::Run && !(machine_.levelEnded && machine_.levels.size() == 1)) {
    if (machine_.clock >= latest) return false;
    if (machine_.levelEnded) endTopLevel();  // of an error OB
    machine_.levelEnded = false;
    machine_.horizon = latest;
    engine_.run(machine_);
  }
  if (mode() == Mode::Run) endTopLevel();
  return mode() == Mode::Run;
}

}  // namespace merker::cpu
