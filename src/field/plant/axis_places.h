// What lies along an axis: zero marks of the encoder, the reference switch, a workpiece. Each is
// passed in the order of position, however fast (POS-PLANT-10, -11, -13).
#pragma once

#include <cstdint>
#include <limits>

namespace merker::plant {

// What the terminals of the CPU see of a movement.
class AxisObserver {
 public:
  virtual ~AxisObserver() = default;
  virtual void moved(std::int64_t pulses) = 0;  // in one direction
  virtual void zeroMark() = 0;
  virtual void referenceSwitch(bool on) = 0;
  virtual void lengthInput(bool on) = 0;
};

// Active from one pulse up to before another one; without a revolution it is there once.
struct Zone {
  std::int64_t from = 0, to = 0;
  bool holds(std::int64_t pulse, std::int64_t revolution) const;
};

struct AxisPlaces {
  std::int64_t betweenMarks = 2000;  // pulses of an encoder revolution
  std::int64_t firstMark = 0;
  std::int64_t revolution = 0;  // of a rotary axis; 0: linear
  Zone reference{30'300, 35'300};
  Zone workpiece{1000, 1250};
  std::int64_t backlash = 0;  // pulses of the motor after a turn before the load moves

  // Where the load is when the motor, with the encoder, has come to a pulse. The motor pushes it in
  // direction plus and draws it at the other end of the play (POS-PLANT-22).
  std::int64_t loadAt(std::int64_t load, std::int64_t pulse) const;
  bool isMark(std::int64_t pulse) const;
  // The next pulse of the motor in a direction where something changes; `to` if nothing does
  // before.
  std::int64_t next(std::int64_t pulse, std::int64_t to) const;
};

}  // namespace merker::plant
