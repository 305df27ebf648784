#include "plant/positioner.h"

#include <algorithm>

namespace merker::plant {
namespace {

// STW1 and ZSW1 in positioning mode.
constexpr std::uint16_t kDoNotReject = 1 << 4, kNoIntermediateStop = 1 << 5;
constexpr std::uint16_t kActivate = 1 << 6;  // 0 -> 1
constexpr std::uint16_t kStartHoming = 1 << 11;
constexpr std::uint16_t kTargetReached = 1 << 10, kHomePositionSet = 1 << 11,
                        kAcknowledged = 1 << 12, kStandstill = 1 << 13, kAccelerates = 1 << 14,
                        kBrakes = 1 << 15;
constexpr std::uint16_t kMdi = 1 << 15;      // of SATZANW and AKTSATZ
constexpr std::uint16_t kAbsolute = 1 << 0;  // of MDI_MOD; else relative

// 4000h is 100 %; a drive has a least acceleration (docs/compatibility.md).
double share(double percent) { return std::clamp(percent / 0x4000, 0.001, 1.0); }

}  // namespace

Positioner::Positioner(const PositionerSettings& settings, Drive& drive)
    : s_(settings),
      drive_(drive),
      offset_(settings.absolute ? 0 : drive.settings().start),
      homed_(settings.absolute),
      limits_{drive.settings().speed, drive.settings().acceleration,
              drive.settings().acceleration} {}

// A task needs its edge, and for an absolute place the reference point.
void Positioner::accept(Instant now, const PositionerSetpoints& p) {
  const bool absolute = (p.mode & kAbsolute) != 0;
  if ((p.satzanw & kMdi) == 0) return drive_.states().warn(drive_fault::kNoBlock);
  if (absolute && !homed_) return drive_.states().warn(drive_fault::kNoReference);
  if (p.velocity <= 0) return drive_.states().warn(drive_fault::kIllegalTask);
  drive_.states().warn(0);
  const DriveSettings& s = drive_.settings();
  constexpr double kLuPerSecond = 1000.0 / 60;
  limits_ = {std::min(p.velocity * kLuPerSecond, s.speed), s.acceleration * share(p.acceleration),
             s.acceleration * share(p.deceleration)};
  target_ = p.target + (absolute ? offset_ : drive_.motion().place(now));
  task_ = Task::Travel;
  acknowledged_ = true;
  reached_ = false;
}

// The cam is left in direction plus: there is the reference point, exactly, as a drive latches it.
void Positioner::followHoming(Instant now, bool wanted, bool rising) {
  if (rising) task_ = Task::Homing, found_ = reached_ = false, homed_ = s_.absolute;
  if (task_ == Task::Homing && !wanted) task_ = Task::None;
  const bool left = wasOnCam_ && !onCam(now);
  wasOnCam_ = onCam(now);
  if (task_ != Task::Homing || found_ || !left) return;
  found_ = homed_ = true;
  offset_ = s_.reference - s_.home;
  drive_.states().warn(0);
}

Drive::Order Positioner::homing(Instant now) const {
  const double acceleration = drive_.settings().acceleration;
  if (found_) return {s_.reference, true, {s_.homingSpeed, acceleration, acceleration}};
  return Drive::toSpeed(onCam(now) ? s_.homingSpeed : -s_.homingSpeed, acceleration);
}

Drive::Order Positioner::jog(std::uint16_t stw1) const {
  const int direction = int{has(stw1, Stw1::JogPlus)} - int{has(stw1, Stw1::JogMinus)};
  return Drive::toSpeed(direction * s_.jogSpeed, drive_.settings().acceleration);
}

Drive::Order Positioner::order(Instant now) const {
  const std::uint16_t stw1 = drive_.states().control();
  if (task_ == Task::None) return jog(stw1);
  if ((stw1 & kNoIntermediateStop) == 0) return Drive::toSpeed(0, limits_.deceleration);
  return task_ == Task::Homing ? homing(now) : Drive::Order{target_, true, limits_};
}

Drive::Order Positioner::wanted(Instant now, const PositionerSetpoints& setpoints) {
  const std::uint16_t stw1 = drive_.states().control();
  const auto rises = [&](std::uint16_t bit) { return (stw1 & bit) != 0 && (before_ & bit) == 0; };
  const bool allowed = drive_.operates() && (stw1 & kDoNotReject) != 0;
  if (!allowed) task_ = Task::None;
  if (allowed && rises(kActivate)) accept(now, setpoints);
  followHoming(now, allowed && (stw1 & kStartHoming) != 0, allowed && rises(kStartHoming));
  if ((stw1 & kActivate) == 0) acknowledged_ = false;
  before_ = stw1;
  const double goal = task_ == Task::Homing ? s_.reference : target_;
  const bool arrives = task_ == Task::Travel || (task_ == Task::Homing && found_);
  if (arrives && drive_.stands(now) && drive_.motion().place(now) == goal)
    task_ = Task::None, reached_ = true;
  return order(now);
}

std::uint16_t Positioner::statusBits(Instant now) const {
  const double change = drive_.motion().acceleration(now) * drive_.motion().speed(now);
  const auto bit = [](bool on, std::uint16_t value) { return on ? value : std::uint16_t{0}; };
  return static_cast<std::uint16_t>(bit(reached_, kTargetReached) | bit(homed_, kHomePositionSet) |
                                    bit(acknowledged_, kAcknowledged) |
                                    bit(drive_.stands(now), kStandstill) |
                                    bit(change > 0, kAccelerates) | bit(change < 0, kBrakes));
}

std::uint16_t Positioner::currentBlock() const { return task_ == Task::Travel ? kMdi : 0; }

}  // namespace merker::plant
