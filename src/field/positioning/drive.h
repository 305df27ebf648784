// What a run does with the drive, cycle by cycle; analog and digital outputs do it in their own
// way.
#pragma once

#include <cstdint>
#include <limits>

#include "positioning/motion.h"

namespace merker::positioning {

constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();

// Pulses to the switching points of a run; not positive: passed.
struct Ahead {
  std::int64_t changeover = kFar, cutOff = kFar;
};

struct Outputs {
  std::int64_t setPoint = 0;  // of AO 0; its sign is that of the voltage
  bool enable = false;        // CONV_EN
  bool direction = false;     // CONV_DIR
  std::uint8_t digital = 0;   // Q0 is bit 0
};

class Drive {
 public:
  virtual ~Drive() = default;

  // A run begins or turns, the drive stands; or it takes on new parameters in the same direction.
  virtual void start(int direction, const Motion& motion) = 0;
  virtual void slow() = 0;  // from now on not above creep speed
  // A cycle of a run; true: it came to its end on the way, before the cut-off point (POS-RUN-13).
  virtual bool travel(const Ahead& ahead) = 0;
  // A cycle of ramping down, `travelled` pulses behind its beginning; true: the drive stands.
  virtual bool rampDown(std::int64_t travelled) = 0;
  // Whether outputs stay off for a cycle when a run turns (POS-JOG-06).
  virtual bool pauses() const = 0;
  virtual void halt() = 0;   // stands at once, the run may turn
  virtual void off() = 0;    // the run has ended
  virtual void abort() = 0;  // the run is aborted
  virtual void idle() {}     // a cycle without a run
  virtual Outputs outputs(bool positionReached) const = 0;

  bool accelerates() const { return ramp_ == Ramp::Up; }
  bool decelerates() const { return ramp_ == Ramp::Down; }

 protected:
  enum class Ramp : std::uint8_t { None, Up, Down };
  Ramp ramp_ = Ramp::None;
};

}  // namespace merker::positioning
