#include "plant/drive.h"

namespace merker::plant {

// Without its master it stops as by OFF3 (F01910: bus interrupted, master off or in STOP).
void Drive::observe(Instant now, std::uint16_t stw1, const DriveConditions& conditions) {
  const bool lost = hadMaster_ && !conditions.master;
  hadMaster_ = conditions.master;
  states_.step(stw1, stands(now));
  if (lost) states_.fault(drive_fault::kNoMaster, StopReaction::Quick, stands(now));
  if (conditions.externalFault)
    states_.fault(drive_fault::kExternal, StopReaction::Coast, stands(now));
  watchAxis(now, conditions);
}

void Drive::watchAxis(Instant now, const DriveConditions& conditions) {
  const double speed = motion_.speed(now);
  if (speed == 0) return;
  const bool operated = operates();
  if (conditions.blocked) {
    motion_.hold(now);
    if (operated) states_.fault(drive_fault::kFollowingError, StopReaction::Coast, true);
  } else if (operated && speed < 0 && atLowSwitch(now)) {
    states_.fault(drive_fault::kLowSwitch, StopReaction::Quick, false);
  } else if (operated && speed > 0 && atHighSwitch(now)) {
    states_.fault(drive_fault::kHighSwitch, StopReaction::Quick, false);
  }
}

Drive::Order Drive::stop() const {
  if (states_.state() != DriveState::SwitchingOff) return toSpeed(0, s_.coast);
  return toSpeed(0, states_.brakesQuickly() ? s_.quickStop : s_.acceleration);
}

// The way is worked out anew only when the order is another one.
void Drive::move(Instant now, const Order& wanted) {
  const Order order = operates() ? wanted : stop();
  if (order == order_) return;
  order_ = order;
  if (order.place)
    motion_.toPlace(now, order.target, order.limits);
  else
    motion_.toSpeed(now, order.target, order.limits.acceleration);
}

}  // namespace merker::plant
