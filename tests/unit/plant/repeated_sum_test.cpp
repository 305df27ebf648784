// Sums in one go are the same as step by step, to the last bit.
#include "plant/repeated_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace merker::plant {
namespace {

double oneByOne(double sum, double summand, std::int64_t count) {
  for (; count > 0; --count) sum += summand;
  return sum;
}

TEST(RepeatedSum, IsTheSameAsStepByStep) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-2, 2), exponent(-30, 3);
  for (int round = 0; round < 2000; ++round) {
    const double sum = place(random);
    const double summand = place(random) * std::pow(10, exponent(random));
    const auto count = static_cast<std::int64_t>(random() % 5000);
    ASSERT_EQ(addRepeatedly(sum, summand, count), oneByOne(sum, summand, count))
        << sum << " + " << count << " * " << summand;
  }
}

// Past many powers of two, on both sides of zero.
TEST(RepeatedSum, PassesZeroAndPowersOfTwo) {
  for (const double summand : {1e-4, 0.1 / 3, 1.0 / 1024, 3e-9})
    for (const double sum : {0.0, -0.2, -1.0, 1e-300, 1e-310, 1e-17}) {
      EXPECT_EQ(addRepeatedly(sum, summand, 100'000), oneByOne(sum, summand, 100'000));
      EXPECT_EQ(addRepeatedly(-sum, -summand, 100'000), oneByOne(-sum, -summand, 100'000));
    }
}

// Half a unit of the last place goes to the even neighbour, up and down by turns.
TEST(RepeatedSum, RoundsHalvesByTurns) {
  const double unit = std::numeric_limits<double>::epsilon();
  for (const double sum : {1.0, 1 + unit, 2 - 100 * unit})
    for (const double summand : {0.5 * unit, 1.5 * unit, 2.5 * unit, -0.25 * unit, -1.5 * unit})
      EXPECT_EQ(addRepeatedly(sum, summand, 1000), oneByOne(sum, summand, 1000));
}

TEST(RepeatedSum, StandsWhereTheSummandIsTooSmall) {
  EXPECT_EQ(addRepeatedly(1, 1e-20, std::numeric_limits<std::int64_t>::max()), 1);
  EXPECT_EQ(addRepeatedly(0.5, 0, 1'000'000'000), 0.5);
  const double beyond = std::numeric_limits<double>::infinity();
  EXPECT_EQ(addRepeatedly(beyond, 1, 1000), beyond);
  EXPECT_EQ(addRepeatedly(1e308, 1e305, 1'000'000), beyond);
}

TEST(RepeatedSum, TakesALongTimeInOneGo) {
  EXPECT_EQ(addRepeatedly(0, 1.0 / 1024, std::int64_t{1} << 50), std::ldexp(1, 40));
}

}  // namespace
}  // namespace merker::plant
