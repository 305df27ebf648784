// The actual position: pulses of the encoder as the hardware counts them, and the coordinate that
// the axis has by its reference point. Coordinates of a rotary axis count on over its end.
#pragma once

#include <cstdint>

#include "io/axis_channel.h"

namespace merker::positioning {

class Position {
 public:
  explicit Position(const io::AxisChannel& parameters);

  void reset(std::int64_t coordinate);  // STOP to RUN
  void move(std::int64_t pulses);       // of the encoder, all in one direction
  void shift(std::int64_t pulses) { offset_ += pulses; }
  // A zero mark at this position; false: other than between the marks before, there were not as
  // many pulses (POS-MON-02).
  bool zeroMark();

  std::int64_t now() const { return count_ + offset_; }
  bool down() const { return direction_ < 0; }
  int direction() const { return direction_; }
  // How far it has been in a direction since the last cycle (POS-RUN-12).
  std::int64_t farthest(int direction) const { return (direction > 0 ? high_ : low_) + offset_; }
  void beginCycle() { low_ = high_ = count_; }

 private:
  int sign_;
  bool watchesMarks_;
  std::int64_t count_ = 0, offset_ = 0;
  std::int64_t low_ = 0, high_ = 0;  // counts since the last cycle
  int direction_ = 1;
  bool markKnown_ = false;
  std::int64_t lastMark_ = 0;      // count
  std::int64_t betweenMarks_ = 0;  // pulses, as learned; 0: not yet
};

// A coordinate as it is shown: of a rotary axis from 0 to its end - 1 (POS-PARAM-17).
std::int64_t shown(std::int64_t coordinate, const io::AxisChannel& parameters);

}  // namespace merker::positioning
