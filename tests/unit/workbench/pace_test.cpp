#include "workbench/pace.h"

#include "bench.h"

namespace merker::workbench::test {
namespace {

// A clock on the wall that the test moves; each look costs a microsecond, on a slow machine more.
class Wall {
 public:
  std::int64_t cost = 1'000;  // ns
  Pacer::WallClock clock() {
    return [this] { return now_ += cost; };
  }
  void pass(Duration time) { now_ += time.ns; }
  double seconds() const { return static_cast<double>(now_) / 1e9; }

 private:
  std::int64_t now_ = 1'000'000'000;
};

class Pace : public ::testing::Test {
 protected:
  void slices(int count) {
    for (int i = 0; i < count; ++i) {
      wall.pass(Duration::milliseconds(5));
      while (bench.workbench.advance(wall.clock(), Duration::milliseconds(5)))
        if (fast) break;
    }
  }
  // Of a machine on which each look at the clock takes a millisecond.
  void slowly(int count) {
    wall.cost = 1'000'000;
    for (int i = 0; i < count; ++i) {
      wall.pass(Duration::milliseconds(5));
      bench.workbench.advance(wall.clock(), Duration::milliseconds(5));
    }
    wall.cost = 1'000;
  }
  double seconds() { return static_cast<double>(plc().now().ns) / 1e9; }
  controller::Controller& plc() { return bench.workbench.plc()->controller(); }

  Bench bench;
  Wall wall;
  bool fast = false;
};

TEST_F(Pace, RealTimeFollowsTheWall) {
  slices(1);
  const double begin = seconds();
  slices(200);
  EXPECT_NEAR(seconds() - begin, 1.0, 0.05);
  EXPECT_NEAR(bench.state()["reached"].get<double>(), 1.0, 0.05);
}

TEST_F(Pace, AFactorSlowsDownAndSpeedsUp) {
  slices(1);
  for (const double factor : {0.1, 10.0}) {
    bench.call("time.pace", {{"mode", "real"}, {"factor", factor}});
    slices(1);
    const double begin = seconds();
    slices(200);
    EXPECT_NEAR(seconds() - begin, factor, 0.06 * factor);
  }
}

// What is lost while the machine sleeps is not made good.
TEST_F(Pace, AJumpOfTheWallIsGivenUp) {
  slices(10);
  const double begin = seconds();
  wall.pass(Duration::seconds(3600));
  slices(10);
  EXPECT_LT(seconds() - begin, 100.0);
}

// A machine that is too slow for a while: of what it is behind at most 200 ms of the wall are made
// good, times the factor.
TEST_F(Pace, WhatCannotBeMadeGoodIsGivenUp) {
  for (const double factor : {1.0, 10.0}) {
    bench.call("time.pace", {{"mode", "real"}, {"factor", factor}});
    slices(10);
    slowly(200);  // more than 1 s behind
    const double begin = seconds();
    slices(200);
    EXPECT_GT(seconds() - begin, 0.99 * factor);
    EXPECT_LT(seconds() - begin, 1.25 * factor);
  }
}

// A short delay is made good to the last.
TEST_F(Pace, AShortDelayIsMadeGood) {
  slices(10);
  const double begin = seconds(), wallBegan = wall.seconds();
  slowly(15);
  EXPECT_LT(seconds() - begin, 0.1);
  slices(100);
  EXPECT_GT(wall.seconds() - wallBegan, 0.6);
  EXPECT_NEAR(seconds() - begin, wall.seconds() - wallBegan, 0.006);
}

TEST_F(Pace, FastTakesWhatTheMachineGives) {
  fast = true;
  bench.call("time.pace", {{"mode", "fast"}});
  slices(3);
  EXPECT_GT(seconds(), 1.0);
  EXPECT_EQ(bench.state()["pace"]["mode"], "fast");
}

// S7-SIM: single cycles.
TEST_F(Pace, PausedTimeMovesByCyclesOnly) {
  slices(5);
  EXPECT_EQ(bench.problem("time.step"), "P1308");
  bench.call("time.pace", {{"mode", "pause"}});
  slices(5);
  const auto begin = plc().cycles();
  slices(5);
  EXPECT_EQ(plc().cycles(), begin);
  bench.call("time.step");
  slices(5);
  EXPECT_EQ(plc().cycles(), begin + 1);
  bench.call("time.step", {{"cycles", 25}});
  slices(5);
  EXPECT_EQ(plc().cycles(), begin + 26);
}

TEST_F(Pace, StepsEndInStop) {
  bench.call("time.pace", {{"mode", "pause"}});
  bench.call("cpu.stop");
  bench.call("time.step", {{"cycles", 1000}});
  slices(3);
  EXPECT_FALSE(bench.workbench.advance(wall.clock(), Duration::milliseconds(5)));
}

}  // namespace
}  // namespace merker::workbench::test
