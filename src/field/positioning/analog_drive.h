// The drive at the analog output: a set-point that rises and falls in steps of one cycle, and the
// enable of the power section (technology manual 3.4.1).
#pragma once

#include "positioning/drive.h"

namespace merker::positioning {

class AnalogDrive : public Drive {
 public:
  explicit AnalogDrive(const io::AxisChannel& parameters);

  void start(int direction, const Motion& motion) override;
  void slow() override { limit_ = creep_; }
  bool travel(const Ahead& ahead) override;
  bool rampDown(std::int64_t travelled) override;
  bool pauses() const override { return false; }
  void halt() override;
  void off() override;
  void abort() override;
  void idle() override;
  Outputs outputs(bool positionReached) const override;

 private:
  std::int64_t brakingDistance(std::int64_t end) const;
  void brake(std::int64_t end);
  void creep();
  void follow();

  io::AnalogControl control_;
  std::int64_t creep_;
  std::int64_t delay_;  // cycles from an abort to the end of the enable

  int direction_ = 1;
  std::int64_t setPoint_ = 0, limit_ = 0;
  std::int64_t up_ = 0, down_ = 0;  // per cycle
  std::int64_t deceleration_ = 1;
  bool toStandstill_ = false;  // without creep speed, down to 0 before the cut-off point
  bool braking_ = false;
  bool enabled_ = false;
  std::int64_t waiting_ = 0;  // cycles
};

}  // namespace merker::positioning
