// A movement with evenly changing speed, in closed form (POS-PLANT-02, -03, -12).
#include "signal/ramp.h"

#include <gtest/gtest.h>

namespace merker::signal {
namespace {

// 4 ms from 1000 to 900 pulses/s: 3.8 pulses.
TEST(Ramp, PositionInBetween) {
  Ramp ramp;
  ramp.start = Instant{1000};
  ramp.position = 10 * kPulse;
  ramp.speed = 1'000'000;
  ramp.last = 900'000;
  EXPECT_EQ(ramp.at(ramp.start), 10 * kPulse);
  EXPECT_EQ(ramp.at(ramp.start + Duration::milliseconds(2)), 11'950'000);
  EXPECT_EQ(ramp.end(), 13'800'000);
  EXPECT_EQ(ramp.at(Instant{1'000'000'000}), 13'800'000);
  EXPECT_FALSE(ramp.turns());
}

// Each pulse begins at the first nanosecond at which the position has come to it.
TEST(Ramp, TimeOfAPulse) {
  Ramp ramp;
  ramp.speed = 1'000'000;
  ramp.last = 900'000;
  for (std::int64_t pulse = 1; pulse <= 3; ++pulse) {
    const Instant at = ramp.reaches(pulse);
    EXPECT_EQ(pulseOf(ramp.at(at)), pulse);
    EXPECT_EQ(pulseOf(ramp.at(at - Duration{1})), pulse - 1);
  }
  EXPECT_EQ(ramp.reaches(0), ramp.start);
  EXPECT_EQ(ramp.reaches(4), Instant::never());
  EXPECT_EQ(ramp.reaches(-1), Instant::never());
}

// Up to 0.5 pulses ahead and back: -500 to 500 pulses/s.
TEST(Ramp, Turns) {
  Ramp ramp;
  ramp.position = 2 * kPulse;
  ramp.speed = -500'000;
  ramp.last = 500'000;
  EXPECT_TRUE(ramp.turns());
  EXPECT_EQ(ramp.turningPoint(), 1'500'000);
  EXPECT_EQ(ramp.end(), 2 * kPulse);
  const Instant below = ramp.reaches(1);
  EXPECT_EQ(pulseOf(ramp.at(below)), 1);
  EXPECT_LT(below, ramp.start + Duration::microseconds(1));
}

// Backward a pulse is left where the position falls below it.
TEST(Ramp, BackwardAndBelowZero) {
  Ramp ramp;
  ramp.speed = ramp.last = -1'000'000;
  EXPECT_EQ(ramp.end(), -4 * kPulse);
  EXPECT_EQ(pulseOf(-1), -1);
  EXPECT_EQ(pulseOf(-kPulse), -1);
  EXPECT_EQ(pulseOf(-kPulse - 1), -2);
  EXPECT_EQ(ramp.reaches(-2).ns, 1'000'001);
}

}  // namespace
}  // namespace merker::signal
