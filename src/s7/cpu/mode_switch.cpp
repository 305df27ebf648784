#include "cpu/mode_switch.h"

namespace merker::cpu {
namespace {

constexpr Duration kHold = Duration::seconds(3);
constexpr Duration kResetShown = Duration::seconds(3);

bool since(Instant then, Instant now, Duration time) {
  return then != Instant::never() && now >= then + time;
}
bool within(Instant then, Instant now, Duration time) {
  return then != Instant::never() && now <= then + time;
}

}  // namespace

bool ModeSwitch::turn(SwitchPosition to, Instant now) {
  if (to == position_) return false;
  const bool wasPressed = position_ == SwitchPosition::Mres;
  position_ = to;
  if (to == SwitchPosition::Mres) {
    const bool again = within(armed_, now, kHold);
    armed_ = Instant::never();
    (again ? reset_ : pressed_) = now;
    return again;
  }
  armed_ = to == SwitchPosition::Stop && wasPressed && since(pressed_, now, kHold)
               ? now
               : Instant::never();
  pressed_ = Instant::never();
  return false;
}

ModeSwitch::Sequence ModeSwitch::sequence(Instant now) const {
  if (within(reset_, now, kResetShown)) return Sequence::Reset;
  if (pressed_ != Instant::never())
    return since(pressed_, now, kHold) ? Sequence::Armed : Sequence::Pressed;
  return within(armed_, now, kHold) ? Sequence::Armed : Sequence::None;
}

}  // namespace merker::cpu
