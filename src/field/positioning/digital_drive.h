// The drive at the four digital outputs: rapid and creep in two directions, by one of four control
// types (technology manual 4.2.4, 4.4.1).
#pragma once

#include "positioning/drive.h"

namespace merker::positioning {

class DigitalDrive : public Drive {
 public:
  explicit DigitalDrive(const io::AxisChannel& parameters) : control_(parameters.digitalControl) {}

  void start(int direction, const Motion& motion) override;
  void slow() override { rapid_ = false; }
  bool travel(const Ahead& ahead) override;
  bool rampDown(std::int64_t travelled) override;
  bool pauses() const override { return true; }
  void halt() override { stage_ = Stage::Off; }
  void off() override { halt(); }
  void abort() override { halt(); }
  Outputs outputs(bool positionReached) const override;

 private:
  enum class Stage : std::uint8_t { Off, Creep, Rapid };

  std::uint8_t control_;
  int direction_ = 1;
  bool rapid_ = false;
  std::int64_t creepWay_ = 0;  // of ramping down, pulses
  Stage stage_ = Stage::Off;
};

}  // namespace merker::positioning
