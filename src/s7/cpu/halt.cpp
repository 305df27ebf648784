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
  cycle_.delay(by);
  interrupts_.delay(by);
  for (RuntimeMeter& meter : runtimeMeters_) meter.since = meter.since + by;
}

// The instruction that HALT stands before has not been executed yet.
bool Cpu::halt() {
  if (!state_.executing()) return false;
  Place next = log_.here();
  if (next.known) next.offset = engine_.offset(*machine_.top);
  state_.halt(next);
  return true;
}

bool Cpu::resume(bool step) {
  if (mode() != Mode::Halt) return false;
  shiftProgramTime(state_.standing());
  state_.endHalt(step);
  if (mode() != Mode::Run) return true;
  modules_.disableOutputs(false);
  skipTimesOfDay(0x06);  // S7-OBI-07
  return true;
}

// The time of the instruction passes, the time in front of it does not. At the end of a cycle the
// next one begins with its images, so that there is an instruction to stop at.
bool Cpu::singleStep() {
  if (mode() != Mode::Halt) return false;
  shiftProgramTime(state_.standing());
  state_.beginStep();
  while (state_.executing() && machine_.levels.empty()) step(Instant::never());
  if (state_.executing()) {
    machine_.levels.back().wait = 0;
    runInstructions(machine_.clock);
  }
  while (state_.executing() && machine_.levels.empty()) step(Instant::never());
  if (!state_.executing()) return false;
  state_.endStep();
  return true;
}

}  // namespace merker::cpu
