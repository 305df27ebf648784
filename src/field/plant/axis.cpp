#include "plant/axis.h"

#include <algorithm>
#include <cstdlib>

namespace merker::plant {
namespace {

__extension__ typedef __int128 Wide;

constexpr std::int64_t kThousandths = 1000;
constexpr std::int64_t kFullScale = 10'000'000'000;  // nV
constexpr std::int64_t kStep = 4;                    // ms
constexpr std::int64_t kRatedLoad = 1000;
constexpr std::int64_t kWhole = 65'536;  // of `lag`

}  // namespace

Axis::Axis(const AxisSettings& settings, std::int64_t pulse)
    : s_(settings),
      position_(pulse * signal::kPulse),
      pulse_(pulse),
      load_(pulse),
      reference_(settings.places.reference.holds(pulse, settings.places.revolution)),
      workpiece_(settings.places.workpiece.holds(pulse, settings.places.revolution)),
      loadBefore_(position_) {
  ramp_.position = position_;
}

std::int64_t Axis::analogSpeed(const AxisInputs& inputs) const {
  const Wide scaled = Wide{inputs.nanovolts} * s_.fastest * kThousandths;
  const Wide half = scaled < 0 ? -kFullScale / 2 : kFullScale / 2;
  const auto speed = static_cast<std::int64_t>((scaled + half) / kFullScale);
  return s_.section == PowerSection::WithDirection && inputs.direction ? -speed : speed;
}

// A limit switch acts on the power section; the opposite direction stays possible (POS-PLANT-13).
bool Axis::blockedTowards(std::int64_t speed) const {
  return (speed > 0 && load_ > s_.highSwitch) || (speed < 0 && load_ < s_.lowSwitch);
}

// Not enabled: it coasts; then it drifts, or somebody turns it.
Axis::Demand Axis::idle() const {
  return {(hand_ != 0 ? hand_ : s_.drift) * kThousandths, s_.coast};
}

Axis::Demand Axis::moved(std::int64_t speed, std::int64_t acceleration) const {
  if (faults.emergencyStop || blockedTowards(speed)) return {0, s_.coast};
  return {speed, acceleration};
}

Axis::Demand Axis::demand(const AxisInputs& inputs) const {
  if (s_.section != PowerSection::Contactors) {
    if (!inputs.enable) return idle();
    const bool sticks = speed_ == 0 && std::abs(inputs.nanovolts) < s_.stiction;
    return moved(sticks ? 0 : analogSpeed(inputs), s_.acceleration);
  }
  const auto contactors = [&](std::int64_t speed) {
    return moved(speed * kThousandths, s_.contactorAcceleration);
  };
  switch (stageOf(s_.controlType, inputs.contactors)) {
    case Stage::Off:
      return idle();
    case Stage::CreepPlus:
      return contactors(s_.creep);
    case Stage::CreepMinus:
      return contactors(-s_.creep);
    case Stage::RapidPlus:
      return contactors(s_.rapid);
    case Stage::RapidMinus:
      return contactors(-s_.rapid);
  }
  return idle();
}

bool Axis::drives(const AxisInputs& inputs) const {
  if (s_.section != PowerSection::Contactors) return inputs.enable;
  return stageOf(s_.controlType, inputs.contactors) != Stage::Off;
}

// POS-PLANT-04, -05, -09
void Axis::step(const AxisInputs& inputs, AxisObserver& observer) {
  const Demand wanted = demand(inputs);
  const std::int64_t most = kStep * wanted.acceleration * kRatedLoad / s_.load;
  std::int64_t change = wanted.speed - speed_;
  if (s_.lag != 0 && drives(inputs)) change = change * s_.lag / kWhole;
  if (s_.places.backlash != 0) loadBefore_ = loadRamp().end();
  ramp_.position = position_;
  ramp_.speed = faults.blocked ? 0 : speed_;
  ramp_.last = faults.blocked ? 0 : speed_ + std::clamp(change, -most, most);
  speed_ = ramp_.last;
  position_ = ramp_.end();
  if (ramp_.turns()) travel(signal::pulseOf(ramp_.turningPoint()), observer);
  travel(signal::pulseOf(position_), observer);
}

signal::Ramp Axis::loadRamp() const {
  signal::Ramp ramp = ramp_;
  ramp.play = s_.places.backlash * signal::kPulse;
  ramp.load = loadBefore_;
  return ramp;
}

void Axis::travel(std::int64_t to, AxisObserver& observer) {
  while (pulse_ != to) {
    const std::int64_t next = s_.places.next(pulse_, to);
    count(next - pulse_, observer);
    pulse_ = next;
    load_ = s_.places.loadAt(load_, pulse_);
    arrive(observer);
  }
}

void Axis::count(std::int64_t pulses, AxisObserver& observer) {
  if (faults.trackBroken) return;
  const std::int64_t lost = std::min(std::abs(pulses), faults.lost);
  faults.lost -= lost;
  const std::int64_t counted = pulses > 0 ? pulses - lost : pulses + lost;
  observer.moved(faults.swapped ? -counted : counted);
}

// The zero mark needs both tracks (POS-ENC-06).
void Axis::arrive(AxisObserver& observer) {
  const bool slow = std::abs(speed_) <= s_.fastestMark * kThousandths;
  if (s_.places.isMark(pulse_) && slow && !faults.markBroken && !faults.trackBroken)
    observer.zeroMark();
  const bool reference = s_.places.reference.holds(load_, s_.places.revolution);
  if (reference != reference_ && !faults.switchStuck) {
    reference_ = reference;
    observer.referenceSwitch(reference);
  }
  const bool workpiece = s_.places.workpiece.holds(load_, s_.places.revolution);
  if (workpiece != workpiece_) {
    workpiece_ = workpiece;
    observer.lengthInput(workpiece);
  }
}

}  // namespace merker::plant
