// An axis on the bench: channel, block and plant, moved cycle by cycle. What the plant passes on
// its way to a cycle comes before it, what the channel puts out moves the plant behind it.
#pragma once

#include <functional>

#include "plant/axis.h"
#include "positioning/block.h"
#include "positioning/error.h"

namespace merker::positioning {

class Bench : public plant::AxisObserver {
 public:
  explicit Bench(const io::AxisChannel& parameters, const plant::AxisSettings& settings = {},
                 std::int64_t pulse = 0)
      : p(parameters), channel(parameters), block(parameters.output), axis(settings, pulse) {
    command.driveEnable = true;
    if (axis.onReference()) channel.referenceSwitch(true);
  }

  // A call of the block; its status.
  std::uint16_t call() {
    block.call(channel, command);
    return block.answer().status;
  }
  // Start bits are set for one call only.
  std::uint16_t press(bool Command::*bit) {
    command.*bit = true;
    const std::uint16_t status = call();
    command.*bit = false;
    return status;
  }
  std::uint16_t run(int mode, bool Command::*bit, std::int32_t target = 0) {
    command.mode = mode;
    command.target = target;
    call();  // without a start bit
    const std::uint16_t status = press(bit);
    number = -1;
    call();
    return status;
  }
  std::uint16_t job(std::int32_t id, std::int32_t value = 0) {
    command.job = id;
    command.jobValue = value;
    press(&Command::jobRequest);
    const std::uint16_t status = block.answer().jobStatus;
    call();
    return status;
  }
  std::uint16_t acknowledge() {
    press(&Command::acknowledge);
    return call();
  }

  void cycle() {
    axis.step(inputs(), *this);
    ++number;
    channel.cycle();
    if (watch) watch();
  }
  void cycles(int count) {
    while (count-- > 0) cycle();
  }
  // The number of the first cycle from now on in which it holds; -1: in none of a million.
  int until(const std::function<bool()>& holds) {
    for (int i = 0; i < 1'000'000; ++i) {
      cycle();
      if (holds()) return number;
    }
    return -1;
  }
  int untilSet(bool Image::*bit) {
    return until([&] { return channel.image().*bit; });
  }
  int untilReset(bool Image::*bit) {
    return until([&] { return !(channel.image().*bit); });
  }
  int untilStands() {
    return until([&] { return axis.speed() == 0 && channel.outputs().setPoint == 0; });
  }
  int untilError(std::uint16_t error) {
    return until([&] { return (channel.image().errors & error) != 0; });
  }
  Image image() const { return channel.image(); }

  plant::AxisInputs inputs() const {
    const Outputs& outputs = channel.outputs();
    plant::AxisInputs inputs;
    inputs.nanovolts = outputs.setPoint * (10'000'000 / p.highestSpeed);
    inputs.enable = outputs.enable;
    inputs.direction = outputs.direction;
    inputs.contactors = outputs.digital;
    return inputs;
  }

  void moved(std::int64_t pulses) override { channel.move(pulses); }
  void zeroMark() override { channel.zeroMark(); }
  void referenceSwitch(bool on) override { channel.referenceSwitch(on); }
  void lengthInput(bool on) override { channel.lengthInput(on); }

  io::AxisChannel p;
  Channel channel;
  Block block;
  plant::Axis axis;
  Command command;
  int number = -1;  // of the last cycle since the start call
  std::function<void()> watch;
};

// The axis of the golden runs: 10 000 pulses/s at 10 V, creep speed 1000, target range 50.
inline io::AxisChannel analogAxis() {
  io::AxisChannel p;
  p.highestSpeed = 10'000;
  p.creepSpeed = 1000;
  p.targetRange = 50;
  return p;
}

inline io::AxisChannel digitalAxis(std::uint8_t controlType = 1) {
  io::AxisChannel p;
  p.output = io::AxisOutput::Digital;
  p.digitalControl = controlType;
  p.targetRange = 50;
  return p;
}

inline plant::AxisSettings contactors(std::uint8_t controlType = 1) {
  plant::AxisSettings settings;
  settings.section = plant::PowerSection::Contactors;
  settings.controlType = controlType;
  return settings;
}

inline Motion motion(std::int32_t speed, std::int32_t ramp, Differences differences = {}) {
  Motion motion;
  motion.speed = speed;
  motion.acceleration = motion.deceleration = ramp;
  motion.differences = {differences, differences};
  return motion;
}

inline Motion rapid(Differences differences) {
  Motion motion;
  motion.rapid = true;
  motion.differences = {differences, differences};
  return motion;
}

// 200 pulses/s per ms at most: fast enough for tests that do not look at ramps.
inline Motion quick() { return motion(10'000, 100'000); }

}  // namespace merker::positioning
