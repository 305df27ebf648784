// A drive with its axis: what stops it and what it reports, whatever it is told to do. Lengths in
// LU, the unit of length that a drive counts in; seconds.
#pragma once

#include <array>

#include "plant/drive_states.h"
#include "plant/kind.h"
#include "plant/motion.h"

namespace merker::plant {

struct DriveSettings {
  double speed = 1;                      // at 100 %
  double acceleration = 1;               // at 100 %, and of OFF1
  double quickStop = 1, coast = 1;       // deceleration of OFF3, and without pulses
  double lowSwitch = 0, highSwitch = 0;  // hardware limit switches
  double start = 0;
};

// Parameters of every kind of drive; `start`: where it stands if nothing else is said.
constexpr std::array<Parameter, 7> driveParameters(double start) {
  using Form = Parameter::Form;
  return {{{"speed", Form::Number, 100'000, 1, 1e9},          // LU/s at 100 %
           {"acceleration", Form::Number, 500'000, 1, 1e12},  // LU/s^2
           {"quick_stop", Form::Number, 2'000'000, 1, 1e12},
           {"coast", Form::Number, 50'000, 1, 1e12},
           {"low_switch", Form::Number, -20'000, -1e9, 1e9},  // LU
           {"high_switch", Form::Number, 320'000, -1e9, 1e9},
           {"start", Form::Number, start, -1e9, 1e9}}};
}

// Their values.
template <typename Parameters>
DriveSettings driveSettings(Parameters p) {
  return {p["speed"],      p["acceleration"], p["quick_stop"], p["coast"],
          p["low_switch"], p["high_switch"],  p["start"]};
}

// Faults and alarms, by their numbers of SINAMICS (list manual): F01910 setpoint timeout of the
// field bus, F07452 following error, F07491 and F07492 stop cams, F07860 external fault; A07461
// reference point not set, A07462 no such traversing block, A07467 illegal task parameters.
namespace drive_fault {
constexpr std::uint16_t kNoMaster = 1910, kFollowingError = 7452, kLowSwitch = 7491,
                        kHighSwitch = 7492, kExternal = 7860;
constexpr std::uint16_t kNoReference = 7461, kNoBlock = 7462, kIllegalTask = 7467;
}  // namespace drive_fault

struct DriveConditions {
  bool master = false;  // its data are good
  bool blocked = false, externalFault = false;
};

class Drive {
 public:
  // What the motor is to do from now on.
  struct Order {
    double target = 0;  // a speed, or a place
    bool place = false;
    MotionLimits limits;
    bool operator==(const Order&) const = default;
  };
  static Order toSpeed(double speed, double acceleration) {
    return {speed, false, {1, acceleration, acceleration}};
  }

  explicit Drive(const DriveSettings& settings) : s_(settings), motion_(settings.start) {}

  // Faults come, the state follows the control word.
  void observe(Instant now, std::uint16_t stw1, const DriveConditions& conditions);
  bool operates() const { return states_.state() == DriveState::Operation; }
  // `wanted` counts in state operation; else it brakes or coasts.
  void move(Instant now, const Order& wanted);

  const DriveSettings& settings() const { return s_; }
  DriveStates& states() { return states_; }
  const DriveStates& states() const { return states_; }
  const Motion& motion() const { return motion_; }
  bool stands(Instant now) const { return motion_.speed(now) == 0; }
  bool atLowSwitch(Instant now) const { return motion_.place(now) <= s_.lowSwitch; }
  bool atHighSwitch(Instant now) const { return motion_.place(now) >= s_.highSwitch; }

 private:
  void watchAxis(Instant now, const DriveConditions& conditions);
  Order stop() const;

  DriveSettings s_;
  DriveStates states_;
  Motion motion_;
  Order order_;
  bool hadMaster_ = false;
};

// The signals that every kind of drive shows.
template <typename Signals>
void showDrive(const Drive& drive, Instant now, Signals values) {
  values["STATE"] = static_cast<double>(drive.states().state());
  values["FAULT"] = drive.states().faultNumber();
  values["POSITION"] = drive.motion().place(now);
  values["SPEED"] = drive.motion().speed(now);
  values["LOW_SWITCH"] = drive.atLowSwitch(now);
  values["HIGH_SWITCH"] = drive.atHighSwitch(now);
}

}  // namespace merker::plant
