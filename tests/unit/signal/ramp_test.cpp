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

// Gentle ramps are worked out with 64 bits, hard ones with more: the same floor of the same
// formula.
TEST(Ramp, BothWaysOfArithmeticAgree) {
  __extension__ typedef __int128 Wide;
  std::uint64_t seed = 4711;
  const auto random = [&seed](std::int64_t low, std::int64_t high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low +
           static_cast<std::int64_t>((seed >> 16) % static_cast<std::uint64_t>(high - low + 1));
  };
  for (int i = 0; i < 20'000; ++i) {
    Ramp ramp;
    ramp.speed = random(-1'000'000'000, 1'000'000'000);
    ramp.last = ramp.speed + random(-500'002, 500'002) * (i % 10 == 0 ? 100 : 1);
    const std::int64_t passed = random(0, ramp.length.ns), twice = 2 * ramp.length.ns;
    const Wide way =
        Wide{twice} * ramp.speed * passed + Wide{ramp.last - ramp.speed} * passed * passed;
    const Wide scale = Wide{twice} * 1'000'000;
    const Wide floor = way / scale - (way % scale != 0 && way < 0 ? 1 : 0);
    ASSERT_EQ(ramp.at(Instant{passed}), static_cast<std::int64_t>(floor)) << i;
  }
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
