#include "positioning/analog_drive.h"

#include <algorithm>

namespace merker::positioning {

AnalogDrive::AnalogDrive(const io::AxisChannel& parameters)
    : control_(parameters.analogControl),
      creep_(parameters.creepSpeed * kThousandths),
      delay_(cyclesOf(parameters.cutOffDelay)) {}

// A pending cut-off delay is cancelled, the enable stays (POS-END-09).
void AnalogDrive::start(int direction, const Motion& motion) {
  direction_ = direction;
  limit_ = motion.speed * kThousandths;
  up_ = motion.acceleration * kMillisecondsPerCycle;
  down_ = motion.deceleration * kMillisecondsPerCycle;
  deceleration_ = motion.deceleration;
  const Differences& differences = motion.differences.of(direction);
  toStandstill_ = differences.changeover < differences.cutOff;
  braking_ = false;
  waiting_ = 0;
  ramp_ = Ramp::Up;
}

// In whole pulses, from the set-point of the last cycle (POS-RUN-06).
std::int64_t AnalogDrive::brakingDistance(std::int64_t end) const {
  constexpr std::int64_t kSquare = kThousandths * kThousandths;
  return (setPoint_ * setPoint_ - end * end) / (2 * deceleration_ * kSquare);
}

bool AnalogDrive::travel(const Ahead& ahead) {
  enabled_ = true;
  if (toStandstill_) {
    braking_ = braking_ || ahead.cutOff <= brakingDistance(0);
    if (braking_ && setPoint_ == 0) return true;
    braking_ ? brake(0) : follow();
    return false;
  }
  if (ahead.changeover <= 0) {
    creep();
    return false;
  }
  if (setPoint_ > creep_ && ahead.changeover <= brakingDistance(creep_)) braking_ = true;
  braking_ ? brake(creep_) : follow();
  return false;
}

// RAMP_DN from the brake point to the changeover point (POS-RUN-07).
void AnalogDrive::brake(std::int64_t end) {
  setPoint_ = std::max(setPoint_ - down_, end);
  ramp_ = Ramp::Down;
}

// Behind the changeover point: at once, if it is still faster (POS-RUN-08, POS-RUN-15).
void AnalogDrive::creep() {
  setPoint_ = std::min(setPoint_ + up_, creep_);
  ramp_ = setPoint_ < creep_ ? Ramp::Up : Ramp::None;
}

void AnalogDrive::follow() {
  if (setPoint_ > limit_) {
    setPoint_ = std::max(setPoint_ - down_, limit_);
    ramp_ = setPoint_ > limit_ ? Ramp::Down : Ramp::None;
  } else {
    setPoint_ = std::min(setPoint_ + up_, limit_);
    ramp_ = setPoint_ < limit_ ? Ramp::Up : Ramp::None;
  }
}

// It has ended in the cycle behind the one that wrote 0 (POS-END-03).
bool AnalogDrive::rampDown(std::int64_t) {
  if (setPoint_ == 0) return true;
  brake(0);
  return false;
}

void AnalogDrive::halt() {
  setPoint_ = 0;
  ramp_ = Ramp::None;
}

void AnalogDrive::off() {
  halt();
  enabled_ = false;
}

// The delay begins with the cycle that writes 0 (POS-RUN-20).
void AnalogDrive::abort() {
  halt();
  waiting_ = delay_ + 1;
}

void AnalogDrive::idle() {
  if (waiting_ > 0 && --waiting_ == 0) enabled_ = false;
}

Outputs AnalogDrive::outputs(bool) const {
  const bool withDirection = control_ == io::AnalogControl::WithDirection;
  Outputs outputs;
  outputs.setPoint = withDirection ? setPoint_ : setPoint_ * direction_;
  outputs.enable = enabled_;
  outputs.direction = withDirection && enabled_ && direction_ < 0;  // POS-RUN-17
  return outputs;
}

}  // namespace merker::positioning
