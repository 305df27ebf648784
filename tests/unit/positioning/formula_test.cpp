// Runs with other parameters than those of the golden ones: every switching cycle against the
// formulas of the manual, written down here once more in the plainest way.
#include <gtest/gtest.h>

#include <random>

#include "bench.h"

namespace merker::positioning {
namespace {

struct Parameters {
  std::int64_t speed, acceleration, deceleration, creep, changeover, cutOff, distance;
  int direction;
};

struct Cycles {
  int rampUp = -1, brake = -1, changeover = -1, cutOff = -1;
  std::int64_t position = 0;  // at the cut-off point, millionths
  bool operator==(const Cycles&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Cycles& c) {
  return out << c.rampUp << " " << c.brake << " " << c.changeover << " " << c.cutOff << " at "
             << c.position;
}

// In pulses and pulses/s; the plant follows with 100 000 pulses/s^2 at most. Positions in the
// direction of the run.
Cycles expected(const Parameters& p) {
  Cycles cycles;
  double position = 0, setPoint = 0, speed = 0;
  bool braking = false;
  for (int cycle = 0; cycle < 10'000'000; ++cycle) {
    const double seen = p.direction > 0 ? std::floor(position + 1e-7) : std::ceil(position - 1e-7);
    // The encoder counts down as soon as the axis leaves a pulse.
    const double counted = p.direction > 0 ? seen : std::floor(-position + 1e-7) * -1;
    const double toChange = static_cast<double>(p.distance - p.changeover) - counted;
    const double toEnd = static_cast<double>(p.distance - p.cutOff) - counted;
    if (toChange <= 0 && cycles.changeover < 0) cycles.changeover = cycle;
    if (toEnd <= 0) {
      cycles.cutOff = cycle;
      if (cycles.rampUp < 0) cycles.rampUp = cycle;
      cycles.position = p.direction * std::llround(position * 1e6);
      return cycles;
    }
    const double creep = static_cast<double>(p.creep),
                 rise = 0.004 * static_cast<double>(p.acceleration),
                 fall = 0.004 * static_cast<double>(p.deceleration);
    const double brake =
        (setPoint * setPoint - creep * creep) / (2 * static_cast<double>(p.deceleration));
    if (toChange <= 0) {
      setPoint = std::min(setPoint + rise, creep);
    } else {
      if (setPoint > creep && toChange <= brake + 1e-9) braking = true;
      if (braking && cycles.brake < 0) cycles.brake = cycle;
      setPoint = braking ? std::max(setPoint - fall, creep)
                         : std::min(setPoint + rise, static_cast<double>(p.speed));
    }
    if (cycles.rampUp < 0 && (braking || setPoint >= static_cast<double>(p.speed) - 1e-9 ||
                              (toChange <= 0 && setPoint >= creep - 1e-9)))
      cycles.rampUp = cycle;
    const double before = speed;
    speed += std::clamp(setPoint - speed, -400.0, 400.0);
    position += (before + speed) / 2 * 0.004;
  }
  return cycles;
}

Cycles measured(const Parameters& p) {
  io::AxisChannel axis = analogAxis();
  axis.creepSpeed = static_cast<std::int32_t>(p.creep);
  axis.targetRange = 0;
  plant::AxisSettings settings;
  settings.lowSwitch = -100'000'000;
  settings.highSwitch = 100'000'000;
  Bench b(axis, settings);
  b.command.motion.speed = static_cast<std::int32_t>(p.speed);
  b.command.motion.acceleration = static_cast<std::int32_t>(p.acceleration);
  b.command.motion.deceleration = static_cast<std::int32_t>(p.deceleration);
  const Differences differences{static_cast<std::int32_t>(p.changeover),
                                static_cast<std::int32_t>(p.cutOff)};
  b.command.motion.differences = {differences, differences};
  Cycles cycles;
  EXPECT_EQ(b.run(4, p.direction > 0 ? &Command::plus : &Command::minus,
                  static_cast<std::int32_t>(p.distance)),
            kNoError);
  while (cycles.cutOff < 0 && b.number < 1'000'000) {
    b.cycle();
    const Image image = b.image();
    if (cycles.rampUp < 0 && !image.rampUp) cycles.rampUp = b.number;
    if (cycles.brake < 0 && image.rampDown) cycles.brake = b.number;
    if (cycles.changeover < 0 && image.changedOver) cycles.changeover = b.number;
    if (image.cutOff) cycles.cutOff = b.number;
  }
  cycles.position = b.axis.position();
  return cycles;
}

// POS-RUN-04, POS-RUN-05, POS-RUN-06, POS-RUN-07, POS-RUN-08, POS-RUN-09, POS-RUN-14, POS-RUN-15:
// 199 runs, plus and minus, long and short
TEST(Formulas, EverySwitchingCycle) {
  std::mt19937_64 random(4711);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  for (int run = 0; run < 199; ++run) {
    Parameters p;
    p.creep = between(10, 2000);
    p.speed = between(p.creep, 10'000);
    p.acceleration = between(500, 50'000);
    p.deceleration = between(500, 50'000);
    p.cutOff = between(10, 500);
    p.changeover = p.cutOff + between(0, 3000);
    p.distance = p.cutOff + between(1, run % 3 == 0 ? 2000 : 80'000);
    p.direction = run % 2 == 0 ? 1 : -1;
    const Cycles wanted = expected(p), found = measured(p);
    EXPECT_EQ(found, wanted) << "run " << run << " speed " << p.speed << " creep " << p.creep;
  }
}

}  // namespace
}  // namespace merker::positioning
