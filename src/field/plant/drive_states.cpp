#include "plant/drive_states.h"

namespace merker::plant {

// Of several transitions the stronger stop wins: OFF2, OFF3, OFF1, no enable.
DriveState DriveStates::next(std::uint16_t stw1, bool stands) const {
  const bool on = has(stw1, Stw1::On), coasts = !has(stw1, Stw1::NoCoastStop);
  const bool quick = !has(stw1, Stw1::NoQuickStop), enabled = has(stw1, Stw1::EnableOperation);
  using enum DriveState;
  switch (state_) {
    case Inhibited:
      return fault_ == 0 && !on && !coasts && !quick ? ReadyToSwitchOn : Inhibited;
    case ReadyToSwitchOn:
      return coasts || quick ? Inhibited : on ? SwitchedOn : ReadyToSwitchOn;
    case SwitchedOn:
      return coasts || quick ? Inhibited : !on ? ReadyToSwitchOn : enabled ? Operation : SwitchedOn;
    case Operation:
      return coasts ? Inhibited : quick || !on ? SwitchingOff : enabled ? Operation : SwitchedOn;
    case SwitchingOff: {
      const bool quickly = quick_ || quick;
      if (coasts) return Inhibited;
      if (stands || !enabled) return quickly ? Inhibited : ReadyToSwitchOn;
      return on && !quickly ? Operation : SwitchingOff;
    }
  }
  return Inhibited;
}

void DriveStates::step(std::uint16_t stw1, bool stands) {
  const bool acknowledged = has(stw1, Stw1::Acknowledge) && !has(stw1_, Stw1::Acknowledge);
  if (acknowledged) fault_ = warning_ = 0;
  stw1_ = stw1;
  for (DriveState to = next(stw1, stands); to != state_; to = next(stw1, stands)) {
    if (to == DriveState::SwitchingOff) quick_ = false;
    state_ = to;
    if (to == DriveState::Inhibited) break;  // the machine rests there for a step
  }
  if (state_ == DriveState::SwitchingOff) quick_ |= !has(stw1, Stw1::NoQuickStop);
}

void DriveStates::fault(std::uint16_t number, StopReaction reaction, bool stands) {
  if (fault_ != 0) return;
  fault_ = number;
  const bool drives = state_ == DriveState::Operation || state_ == DriveState::SwitchingOff;
  const bool brakes = reaction == StopReaction::Quick && drives && !stands;
  state_ = brakes ? DriveState::SwitchingOff : DriveState::Inhibited;
  quick_ = brakes;
}

std::uint16_t DriveStates::statusBits() const {
  using enum DriveState;
  const bool ready = state_ != Inhibited, switchedOn = ready && state_ != ReadyToSwitchOn;
  return static_cast<std::uint16_t>(
      bitIf(ready, Zsw1::ReadyToSwitchOn) | bitIf(switchedOn, Zsw1::SwitchedOn) |
      bitIf(state_ == Operation, Zsw1::OperationEnabled) | bitIf(fault_ != 0, Zsw1::Fault) |
      bitIf(has(stw1_, Stw1::NoCoastStop), Zsw1::NoCoastStop) |
      bitIf(has(stw1_, Stw1::NoQuickStop) && !brakesQuickly(), Zsw1::NoQuickStop) |
      bitIf(state_ == Inhibited, Zsw1::Inhibited) | bitIf(warning_ != 0, Zsw1::Warning) |
      bitIf(true, Zsw1::ControlRequested));
}

}  // namespace merker::plant
