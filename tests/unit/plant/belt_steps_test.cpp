// Many steps of the belt at once are the same as one after the other, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "plant/belt.h"

namespace merker::plant {
namespace {

using Outs = std::array<bool, Belt::kSliders>;

void expectSame(const Belt& a, const Belt& b) {
  for (std::size_t i = 0; i < Belt::kBoxes; ++i) {
    EXPECT_EQ(a.boxes()[i].size, b.boxes()[i].size);
    EXPECT_EQ(a.boxes()[i].front, b.boxes()[i].front);
    EXPECT_EQ(a.boxes()[i].pushed, b.boxes()[i].pushed);
    EXPECT_EQ(a.boxes()[i].slider, b.boxes()[i].slider);
  }
  for (std::size_t i = 0; i < Belt::kSliders; ++i) EXPECT_EQ(a.stroke(i), b.stroke(i));
  EXPECT_EQ(a.counts().bins, b.counts().bins);
  EXPECT_EQ(a.counts().good, b.counts().good);
  EXPECT_EQ(a.counts().wrong, b.counts().wrong);
}

int pushed = 0;  // boxes that came into a bin, in all runs

void run(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  Belt together, single;
  Outs out{};
  for (int change = 0; change < 60; ++change) {
    const auto size = static_cast<BoxSize>(1 + below(3));
    if (below(3) == 0) EXPECT_EQ(together.put(size), single.put(size));
    for (bool& slider : out) slider = below(2) == 0;
    const double speed = below(8) == 0 ? 0 : 0.02 * (1 + below(20));  // m/s
    const int steps = below(4) == 0 ? below(4) : below(900);
    together.move(0.001, speed, out, steps);
    for (int i = 0; i < steps; ++i) single.move(0.001, speed, out);
    expectSame(together, single);
  }
  for (const int boxes : single.counts().bins) pushed += boxes;
}

TEST(Belt, manyStepsAtOnceAreTheSame) {
  pushed = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    run(seed);
    if (HasFailure()) break;
  }
  EXPECT_GT(pushed, 100);
}

}  // namespace
}  // namespace merker::plant
