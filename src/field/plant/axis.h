// An axis with its drive, in steps of the cycle of the positioning channel. Within a step its speed
// changes evenly, so that the position is a closed form of time (POS-PLANT-02 to -18). Whole
// numbers only: thousandths of a pulse per second, millionths of a pulse.
#pragma once

#include "plant/axis_inputs.h"
#include "plant/axis_places.h"
#include "signal/ramp.h"

namespace merker::plant {

struct AxisSettings {
  PowerSection section = PowerSection::Bipolar;
  std::uint8_t controlType = 1;
  // pulses/s
  std::int64_t fastest = 10'000;  // at 10 V
  std::int64_t rapid = 10'000, creep = 1000;
  std::int64_t drift = 0;  // of the drive that is not enabled
  // pulses/s^2
  std::int64_t acceleration = 100'000;  // most of the analog drive
  std::int64_t contactorAcceleration = 20'000;
  std::int64_t coast = 5000;  // not enabled
  std::int64_t load = 1000;   // per mille of the rated inertia
  std::int64_t lag = 0;       // share of a change in one step, of 65536; 0: all
  std::int64_t stiction = 0;  // nV that move an axis that stands
  std::int64_t lowSwitch = -20'000, highSwitch = 320'000;  // hardware limit switches, pulses
  std::int64_t fastestMark = 240'000;  // pulses/s up to which a zero mark is seen
  AxisPlaces places;
};

// What can be wrong with it (POS-PLANT-17).
struct AxisFaults {
  bool swapped = false;      // tracks A and B
  bool trackBroken = false;  // A or B: nothing counts
  bool markBroken = false;   // N
  bool blocked = false;
  bool emergencyStop = false;
  bool switchStuck = false;  // the reference switch keeps its level
  std::int64_t lost = 0;     // so many of the next pulses
};

class Axis {
 public:
  // It stands at a pulse.
  Axis(const AxisSettings& settings, std::int64_t pulse);

  // The next step with these inputs; what is passed on the way is told to `observer`.
  void step(const AxisInputs& inputs, AxisObserver& observer);
  // By hand, while it stands and is not enabled: pulses/s.
  void turn(std::int64_t speed) { hand_ = speed; }

  // Of the motor and of the encoder at its shaft.
  std::int64_t position() const { return position_; }  // millionths of a pulse
  std::int64_t pulse() const { return pulse_; }
  // Of what it drives, which the switches see.
  std::int64_t load() const { return load_; }  // pulse
  std::int64_t speed() const { return speed_; }
  bool onReference() const { return reference_; }
  // Of the last step; it begins at instant 0.
  const signal::Ramp& ramp() const { return ramp_; }
  signal::Ramp loadRamp() const;
  AxisFaults faults;

 private:
  struct Demand {
    std::int64_t speed = 0, acceleration = 0;
  };
  Demand demand(const AxisInputs& inputs) const;
  Demand moved(std::int64_t speed, std::int64_t acceleration) const;
  Demand idle() const;
  bool drives(const AxisInputs& inputs) const;  // else it coasts
  std::int64_t analogSpeed(const AxisInputs& inputs) const;
  bool blockedTowards(std::int64_t speed) const;
  void travel(std::int64_t to, AxisObserver& observer);
  void count(std::int64_t pulses, AxisObserver& observer);
  void arrive(AxisObserver& observer);

  AxisSettings s_;
  std::int64_t position_, pulse_, load_;
  std::int64_t speed_ = 0, hand_ = 0;
  bool reference_, workpiece_;
  signal::Ramp ramp_;
  std::int64_t loadBefore_;  // at the start of the ramp, millionths of a pulse
};

}  // namespace merker::plant
