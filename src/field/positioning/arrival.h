// Behind the cut-off point: whether the axis comes into the target range, and whether it stays
// there (POS-RUN-10 to -12, POS-MON-11 to -14).
#pragma once

#include <cstdint>

#include "positioning/motion.h"

namespace merker::positioning {

class Arrival {
 public:
  explicit Arrival(const io::AxisChannel& parameters);

  void reset();  // a run starts: nothing is reached, nothing is watched
  void await(int direction, std::int64_t target);
  void arrive(std::int64_t target);  // it is there already
  void stopWaiting() { waiting_ = false; }
  void shift(std::int64_t pulses) { target_ += pulses; }

  bool reached() const { return reached_; }  // POS_RCD
  // The direction in which it waits for the target; 0: it does not.
  int waitsFor() const { return waiting_ ? direction_ : 0; }
  // A cycle; `farthest`: position in that direction since the last one. Error bits.
  std::uint16_t step(std::int64_t position, std::int64_t farthest);

 private:
  void arrived();

  std::int64_t half_;
  std::int64_t approachCycles_;  // 0: not monitored
  bool monitorsRange_;
  int direction_ = 1;
  std::int64_t target_ = 0;
  bool waiting_ = false, reached_ = false, watching_ = false;
  std::int64_t cycles_ = 0;
};

}  // namespace merker::positioning
