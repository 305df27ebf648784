// HALT (S7-STATE-07): the program stands still in front of an instruction; so do its timers, its
// interrupts and the cycle monitoring. Outputs are disabled, the clock goes on.
#include "cpu/cpu.h"

namespace merker::cpu {

// S7-TMR-22
void Cpu::shiftTimers(Duration by) {
  for (S5Timer& timer : machine_.timers)
    if (timer.started) timer.end = timer.end + by;
}

void Cpu::shiftProgramTime(Duration by) {
  shiftTimers(by);
  systemStart_ = systemStart_ + by;
  monitoring_.delay(by);
  cycleStart_ = cycleStart_ + by;
  nextCycle_ = nextCycle_ + by;
  for (CyclicInterrupt& cyclic : interrupts_.cyclic)
    if (cyclic.next != Instant::never()) cyclic.next = cyclic.next + by;
  for (RuntimeMeter& meter : runtimeMeters_) meter.since = meter.since + by;
  for (DelayInterrupt& delay : interrupts_.delay) delay.due = delay.due + by;
}

// The instruction that HALT stands before: it has not been executed yet.
Place Cpu::next() const {
  Place place = here();
  if (place.known) place.offset = engine_.offset(*machine_.top);
  return place;
}

bool Cpu::halt() {
  if (!executes(mode_)) return false;
  report(static_cast<std::uint16_t>(Event::HaltReached), std::string(text(Event::HaltReached)),
         next());
  beforeHalt_ = mode_;
  change(Mode::Halt);
  frozenAt_ = machine_.clock;
  modules_.disableOutputs(true);
  machine_.interrupt();
  return true;
}

bool Cpu::resume() {
  if (mode_ != Mode::Halt) return false;
  shiftProgramTime(machine_.clock - frozenAt_);
  report(Event::HaltLeft);
  change(beforeHalt_);
  if (mode_ != Mode::Run) return true;
  modules_.disableOutputs(false);
  skipTimeOfDay(0x06);  // S7-OBI-07
  return true;
}

// The time of the instruction passes, the time in front of it does not. At the end of a cycle the
// next one begins with its images, so that there is an instruction to stop at.
bool Cpu::singleStep() {
  if (mode_ != Mode::Halt) return false;
  shiftProgramTime(machine_.clock - frozenAt_);
  mode_ = beforeHalt_;
  while (executes(mode_) && machine_.levels.empty()) step(Instant::never());
  if (executes(mode_)) {
    machine_.levels.back().wait = 0;
    runInstructions(machine_.clock);
  }
  while (executes(mode_) && machine_.levels.empty()) step(Instant::never());
  if (!executes(mode_)) return false;
  mode_ = Mode::Halt;
  frozenAt_ = machine_.clock;
  return true;
}

}  // namespace merker::cpu
