// Ways of an axis in closed form.
#include "plant/motion.h"

#include <gtest/gtest.h>

namespace merker::plant {
namespace {

constexpr Instant after(double seconds) {
  return Instant{static_cast<std::int64_t>(seconds * 1e9 + 0.5)};
}

// 100 with speed 20, acceleration 10, deceleration 20: 2 s up (20), 3.5 s (70), 1 s down (10).
TEST(Motion, aTrapezoid) {
  Motion motion(0);
  motion.toPlace(Instant{}, 100, {20, 10, 20});
  EXPECT_DOUBLE_EQ(motion.speed(after(1)), 10);
  EXPECT_DOUBLE_EQ(motion.place(after(2)), 20);
  EXPECT_DOUBLE_EQ(motion.place(after(4)), 60);
  EXPECT_DOUBLE_EQ(motion.acceleration(after(6)), -20);
  EXPECT_DOUBLE_EQ(motion.speed(after(6)), 10);
  EXPECT_EQ(motion.place(after(6.5)), 100);
  EXPECT_EQ(motion.speed(after(6.5)), 0);
}

TEST(Motion, aTriangleWhereTheWayIsShort) {
  Motion motion(5);
  motion.toPlace(after(1), -5, {100, 10, 10});  // top: sqrt(10 * 10)
  EXPECT_DOUBLE_EQ(motion.place(after(2)), 0);
  EXPECT_DOUBLE_EQ(motion.speed(after(2)), -10);
  EXPECT_EQ(motion.place(after(3)), -5);
}

// At speed 20 it needs 20 to stop, and has 10: it comes back.
TEST(Motion, goesPastATargetThatIsTooNear) {
  Motion motion(0);
  motion.toSpeed(Instant{}, 20, 10);
  EXPECT_DOUBLE_EQ(motion.place(after(2)), 20);
  motion.toPlace(after(2), 30, {20, 10, 10});
  EXPECT_DOUBLE_EQ(motion.place(after(4)), 40);
  EXPECT_DOUBLE_EQ(motion.speed(after(4)), 0);
  EXPECT_DOUBLE_EQ(motion.speed(after(5)), -10);
  EXPECT_EQ(motion.place(after(6)), 30);
}

TEST(Motion, theSameTargetAgainChangesNothing) {
  Motion one(0), other(0);
  one.toPlace(Instant{}, 100, {20, 10, 20});
  other.toPlace(Instant{}, 100, {20, 10, 20});
  for (const double t : {1.0, 3.0, 6.0}) other.toPlace(after(t), 100, {20, 10, 20});
  EXPECT_NEAR(one.place(after(6.2)), other.place(after(6.2)), 1e-9);
  EXPECT_EQ(other.place(after(7)), 100);
}

TEST(Motion, brakesThroughZeroToTheOtherDirection) {
  Motion motion(0);
  motion.toSpeed(Instant{}, 10, 10);
  motion.toSpeed(after(1), -10, 10);
  EXPECT_DOUBLE_EQ(motion.speed(after(2)), 0);
  EXPECT_DOUBLE_EQ(motion.place(after(3)), 5);
  motion.hold(after(3));
  EXPECT_DOUBLE_EQ(motion.place(after(9)), 5);
}

}  // namespace
}  // namespace merker::plant
