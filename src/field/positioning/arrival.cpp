#include "positioning/arrival.h"

#include <cstdlib>

#include "positioning/error.h"

namespace merker::positioning {

Arrival::Arrival(const io::AxisChannel& parameters)
    : half_(halfRange(parameters)),
      approachCycles_(parameters.monitors.approach ? cyclesOf(parameters.monitoringTime) : 0),
      monitorsRange_(parameters.monitors.targetRange) {}

void Arrival::reset() { waiting_ = reached_ = watching_ = false; }

void Arrival::await(int direction, std::int64_t target) {
  direction_ = direction;
  target_ = target;
  waiting_ = true;
  cycles_ = 0;
}

void Arrival::arrive(std::int64_t target) {
  target_ = target;
  arrived();
}

void Arrival::arrived() {
  waiting_ = false;
  reached_ = true;
  watching_ = monitorsRange_;
}

// A target that is passed between two cycles has been reached, too (POS-RUN-12). The axis is seen
// to leave the range one cycle later at the earliest.
std::uint16_t Arrival::step(std::int64_t position, std::int64_t farthest) {
  if (waiting_ && direction_ * (farthest - target_) >= -half_) {
    arrived();
    return 0;
  }
  if (waiting_ && approachCycles_ > 0 && cycles_++ >= approachCycles_) {
    waiting_ = false;
    return kTargetApproach;
  }
  if (watching_ && std::abs(position - target_) > half_) {
    watching_ = false;  // until the next start (POS-MON-14)
    return kTargetRange;
  }
  return 0;
}

}  // namespace merker::positioning
