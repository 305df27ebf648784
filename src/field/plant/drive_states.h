// The general state machine of PROFIdrive: from switching on inhibited to operation and back, by
// control word 1, and what of it status word 1 shows. States, transitions and bits: PROFIdrive
// general state diagram as in Eaton MN040010EN, figure 43, and ABB FPBA-01 user's manual, tables 4
// and 5; faults: SINAMICS S120 function manual FH1, 6SL3097-2AB00-0BP4, status word 1.
#pragma once

#include <cstdint>

namespace merker::plant {

// Bits of control word 1 that every drive has; from bit 4 on it depends on what the drive does.
enum class Stw1 : std::uint16_t {
  On = 1 << 0,           // 0: OFF1, stops along its ramp
  NoCoastStop = 1 << 1,  // 0: OFF2
  NoQuickStop = 1 << 2,  // 0: OFF3
  EnableOperation = 1 << 3,
  Acknowledge = 1 << 7,  // 0 -> 1: of a fault
  JogMinus = 1 << 8,
  JogPlus = 1 << 9,
  ControlByPlc = 1 << 10,  // 0: the telegram is not taken over
};
enum class Zsw1 : std::uint16_t {
  ReadyToSwitchOn = 1 << 0,
  SwitchedOn = 1 << 1,
  OperationEnabled = 1 << 2,
  Fault = 1 << 3,
  NoCoastStop = 1 << 4,
  NoQuickStop = 1 << 5,
  Inhibited = 1 << 6,
  Warning = 1 << 7,
  NoDeviation = 1 << 8,  // of speed or position from what is wanted
  ControlRequested = 1 << 9,
};
constexpr bool has(std::uint16_t word, Stw1 bit) {
  return (word & static_cast<std::uint16_t>(bit)) != 0;
}
constexpr std::uint16_t bitIf(bool condition, Zsw1 bit) {
  return condition ? static_cast<std::uint16_t>(bit) : std::uint16_t{0};
}

enum class DriveState : std::uint8_t {
  Inhibited = 1,  // S1: after the start, OFF2, OFF3 or a fault; needs OFF1 and no other stop
  ReadyToSwitchOn,
  SwitchedOn,
  Operation,
  SwitchingOff  // brakes until it stands
};

// How a fault stops the drive.
enum class StopReaction : std::uint8_t { Coast, Quick };

class DriveStates {
 public:
  // With a new control word, or a new standstill. May pass several states.
  void step(std::uint16_t stw1, bool stands);
  // The first fault counts until it is acknowledged.
  void fault(std::uint16_t number, StopReaction reaction, bool stands);
  void warn(std::uint16_t number) { warning_ = number; }

  DriveState state() const { return state_; }
  bool brakesQuickly() const { return state_ == DriveState::SwitchingOff && quick_; }
  std::uint16_t faultNumber() const { return fault_; }
  std::uint16_t warning() const { return warning_; }
  std::uint16_t control() const { return stw1_; }  // as last taken over
  // Bits 0 to 7 and 9.
  std::uint16_t statusBits() const;

 private:
  DriveState next(std::uint16_t stw1, bool stands) const;

  DriveState state_ = DriveState::Inhibited;
  bool quick_ = false;  // SwitchingOff by OFF3
  std::uint16_t stw1_ = 0;
  std::uint16_t fault_ = 0, warning_ = 0;
};

}  // namespace merker::plant
