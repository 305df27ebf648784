#include "softplc/operating_state.h"

#include <utility>

namespace merker::sinumerik {

bool OperatingState::allows(Start kind) const {
  return mode_ != Mode::Off && (kind == Start::Cold || !warmInterrupted_);
}

void OperatingState::start(Start kind) {
  mode_ = Mode::Startup;
  startKind_ = kind;
  holdNext_ = false;  // it was meant for the program that ran before
  warmInterrupted_ = false;
}

void OperatingState::powerOff() {
  warmInterrupted_ = mode_ == Mode::Startup && startKind_ == Start::Warm;
  ranBeforePowerOff_ = executes(mode_);
  mode_ = Mode::Off;
}

bool OperatingState::hold(Instant now) {
  if (!executes(mode_)) return false;
  held_ = {mode_, now};
  mode_ = Mode::Halt;
  return true;
}

std::optional<Duration> OperatingState::resume(Instant now) {
  if (mode_ != Mode::Halt) return std::nullopt;
  mode_ = held_.mode;
  return now - held_.since;
}

bool OperatingState::takeHoldNext() { return std::exchange(holdNext_, false); }

}  // namespace merker::sinumerik
