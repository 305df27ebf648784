// The basic positioner of a drive: travels to places that the master names (MDI), finds its
// reference point, jogs. PROFIdrive application class 3; bits of control and status word 1 as in
// ABB FPBA-01 user's manual, tables 4 and 5, and SIMODRIVE POSMO A user manual, chapter 4.2.
#pragma once

#include "plant/drive.h"

namespace merker::plant {

struct PositionerSettings {
  double homingSpeed = 1, jogSpeed = 1;
  double reference = 0;   // the cam is at this place and everywhere below it
  double home = 0;        // position that its end has
  bool absolute = false;  // an absolute encoder: needs no reference point
};

// Setpoints of standard telegram 9, without STW1.
struct PositionerSetpoints {
  std::uint16_t satzanw = 0, mode = 0;        // MDI_MOD
  double target = 0;                          // LU
  double velocity = 0;                        // 1000 LU/min
  double acceleration = 0, deceleration = 0;  // 4000h: 100 %
};

class Positioner {
 public:
  Positioner(const PositionerSettings& settings, Drive& drive);

  // What the drive is to do, after it has observed the control word.
  Drive::Order wanted(Instant now, const PositionerSetpoints& setpoints);

  double position(Instant now) const { return drive_.motion().place(now) - offset_; }
  bool onCam(Instant now) const { return drive_.motion().place(now) < s_.reference; }
  std::uint16_t statusBits(Instant now) const;  // 10 to 15 of ZSW1
  std::uint16_t currentBlock() const;           // AKTSATZ

 private:
  enum class Task : std::uint8_t { None, Travel, Homing };
  void accept(Instant now, const PositionerSetpoints& setpoints);
  void followHoming(Instant now, bool wanted, bool rising);
  Drive::Order order(Instant now) const;
  Drive::Order homing(Instant now) const;
  Drive::Order jog(std::uint16_t stw1) const;

  PositionerSettings s_;
  Drive& drive_;
  Task task_ = Task::None;
  double offset_;  // place of position 0
  bool homed_, found_ = false, wasOnCam_ = false;
  double target_ = 0;  // place
  MotionLimits limits_;
  bool acknowledged_ = false, reached_ = false;
  std::uint16_t before_ = 0;  // control word
};

}  // namespace merker::plant
