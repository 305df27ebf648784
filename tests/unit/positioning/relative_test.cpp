// Incremental runs, relative and absolute, and runs that go on after STOP (technology manual 3.4.6,
// 3.4.7; POS-INCR, POS-INCA, POS-END-12).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

// Synchronised at 0.
Bench bench(std::int32_t rotaryEnd = 0) {
  io::AxisChannel p = analogAxis();
  p.rotary = rotaryEnd != 0;
  p.rotaryEnd = rotaryEnd;
  Bench b(p);
  b.command.motion = quick();
  b.job(1, 0);
  return b;
}

void finish(Bench& b) {
  b.untilReset(&Image::working);
  b.untilStands();
}

// POS-INCR-01, POS-INCR-02, POS-INCR-03: errors do not add up
TEST(Relative, FromTheLastTarget) {
  Bench b(analogAxis());
  b.command.motion = quick();
  b.command.motion.differences = {{1000, 97}, {1000, 97}};
  for (int i = 1; i <= 10; ++i) {
    ASSERT_EQ(b.run(4, &Command::plus, 1000), kNoError);
    EXPECT_EQ(b.image().lastTarget, 1000 * i);
    finish(b);
    EXPECT_NE(b.image().distanceToGo, 0);
  }
  EXPECT_EQ(b.image().lastTarget, 10'000);
  EXPECT_NEAR(b.image().position, 10'000, 10);
}

// POS-INCR-07, POS-INCR-08, POS-RUN-01, POS-RUN-03
TEST(Relative, Signals) {
  Bench b = bench();
  b.command.mode = 4;
  b.command.target = 5000;
  b.command.plus = true;
  b.call();
  EXPECT_TRUE(b.image().working);
  EXPECT_FALSE(b.image().startEnabled);
  EXPECT_FALSE(b.image().positionReached);
  EXPECT_FALSE(b.channel.outputs().enable);
  b.cycle();
  EXPECT_TRUE(b.channel.outputs().enable);
  b.untilReset(&Image::working);
  EXPECT_TRUE(b.image().startEnabled);
  b.untilSet(&Image::positionReached);
  b.call();  // DIR_P is still there
  EXPECT_FALSE(b.image().working);
  EXPECT_EQ(b.image().lastTarget, 5000);
}

// POS-INCR-06: the distance that is left belongs to the way
TEST(Relative, DistanceToGoCounts) {
  Bench b = bench();
  b.channel.move(50);
  b.cycle();
  EXPECT_EQ(b.run(4, &Command::plus, 100), 0x3503);
  EXPECT_EQ(b.run(4, &Command::plus, 150), kNoError);
  EXPECT_EQ(b.image().lastTarget, 150);
}

void interrupt(Bench& b) {
  b.command.stop = true;
  b.call();
  b.untilReset(&Image::working);
  b.command.stop = false;
  b.call();
}

Bench interrupted(int mode = 4) {
  Bench b = bench();
  b.run(4, &Command::plus, 3000);
  finish(b);
  mode == 4 ? b.run(4, &Command::plus, 20'000) : b.run(5, &Command::start, 23'000);
  b.until([&] { return b.image().position > 12'000; });
  interrupt(b);
  EXPECT_FALSE(b.image().cutOff);
  EXPECT_GT(b.image().distanceToGo, 100);
  return b;
}

// POS-INCR-09, POS-INCR-13, POS-INCA-12, POS-OPEN-15: to the target, whatever the parameters are
// now
TEST(Relative, GoesOn) {
  for (const int mode : {4, 5}) {
    Bench b = interrupted(mode);
    b.command.motion.speed = 7;
    ASSERT_EQ(b.run(4, &Command::plus, 99), kNoError);
    b.until([&] { return b.image().position > 16'000; });
    EXPECT_EQ(b.channel.outputs().setPoint, 10'000'000);
    interrupt(b);
    ASSERT_EQ(b.run(4, &Command::plus, -1), kNoError);
    EXPECT_EQ(b.image().lastTarget, 23'000);
    finish(b);
    EXPECT_TRUE(b.image().positionReached);
    EXPECT_NEAR(b.image().position, 23'000, 25);
  }
}

// POS-INCR-10, POS-OPEN-16: back to where it started: the last target before, or the position
TEST(Relative, GoesBack) {
  for (const int mode : {4, 5}) {
    Bench b = interrupted(mode);
    ASSERT_EQ(b.run(4, &Command::minus, 99), kNoError);
    const std::int32_t start = b.image().lastTarget;
    EXPECT_NEAR(start, 3000, mode == 4 ? 0 : 25);
    interrupt(b);  // POS-INCR-13: the pair is swapped
    ASSERT_EQ(b.run(4, &Command::plus, 99), kNoError);
    EXPECT_EQ(b.image().lastTarget, 23'000);
  }
}

// POS-INCR-11, POS-INCA-12
TEST(Relative, AbsoluteAfterStop) {
  Bench b = interrupted();
  ASSERT_EQ(b.run(5, &Command::start, 5000), kNoError);
  EXPECT_EQ(b.image().lastTarget, 5000);
  finish(b);
  EXPECT_NEAR(b.image().position, 5000, 25);
}

// POS-INCR-12, POS-JOB-15, POS-JOB-16
TEST(Relative, DeletedDistance) {
  Bench b = interrupted();
  EXPECT_EQ(b.job(2), kNoError);
  EXPECT_EQ(b.image().distanceToGo, 0);
  const std::int32_t position = b.image().position;
  EXPECT_EQ(b.run(4, &Command::plus, 1000), kNoError);
  EXPECT_EQ(b.image().lastTarget, position + 1000);
}

// POS-END-12: with no more than the cut-off difference to go the run has ended
TEST(Relative, StopNearTheTarget) {
  Bench b = bench();
  b.command.motion = motion(1000, 100'000, {1000, 500});
  b.run(4, &Command::plus, 5000);
  b.until([&] { return b.image().position >= 4499; });
  interrupt(b);
  EXPECT_LE(b.image().distanceToGo, 500);
  b.run(4, &Command::plus, 2000);
  EXPECT_EQ(b.image().lastTarget, 7000);
}

// POS-INCR-14, POS-RUN-27
TEST(Relative, SeveralTurns) {
  Bench b = bench(1000);
  ASSERT_EQ(b.run(4, &Command::plus, 2500), kNoError);
  EXPECT_EQ(b.image().distanceToGo, 2500);
  EXPECT_EQ(b.image().lastTarget, 500);
  finish(b);
  EXPECT_NEAR(b.image().position, 500, 25);
  EXPECT_NEAR(static_cast<double>(b.axis.pulse()), 2500, 25);
}

// POS-INCA-02, POS-INCA-11, POS-INCA-13
TEST(Absolute, Linear) {
  Bench b = bench();
  for (const std::int32_t target : {5000, -5000, 1000}) {
    ASSERT_EQ(b.run(5, &Command::start, target), kNoError);
    EXPECT_EQ(b.image().lastTarget, target);
    finish(b);
    EXPECT_TRUE(b.image().positionReached);
    EXPECT_NEAR(b.image().position, target, 25);
  }
}

std::int64_t way(std::int32_t end, std::int32_t from, std::int32_t target, bool Command::*bit) {
  Bench b = bench(end);
  b.command.motion.differences = {{100, 100}, {100, 100}};
  b.job(1, from);
  EXPECT_EQ(b.run(5, bit, target), kNoError);
  EXPECT_EQ(b.image().lastTarget, target);
  return b.image().distanceToGo;
}

// POS-INCA-03, POS-INCA-04, POS-INCA-05, POS-INCA-06, POS-INCA-07
TEST(Absolute, Rotary) {
  EXPECT_EQ(way(1000, 100, 900, &Command::plus), 800);
  EXPECT_EQ(way(1000, 100, 900, &Command::minus), -200);
  EXPECT_EQ(way(1000, 100, 900, &Command::start), -200);
  EXPECT_EQ(way(1000, 104, 602, &Command::start), 498);
  EXPECT_EQ(way(1000, 0, 500, &Command::start), 500);
  EXPECT_EQ(way(10'000, 0, 60, &Command::start), -9940);
  EXPECT_EQ(way(10'000, 0, 9940, &Command::start), 9940);
  EXPECT_EQ(way(10'000, 0, 100, &Command::start), -9900);
  EXPECT_EQ(way(10'000, 0, 101, &Command::start), 101);
}

// POS-INCA-07
TEST(Absolute, AlreadyThere) {
  Bench b = bench(10'000);
  ASSERT_EQ(b.run(5, &Command::start, 25), kNoError);
  EXPECT_FALSE(b.image().working);
  EXPECT_TRUE(b.image().positionReached);
}

// POS-INCA-10: switching points on both sides of the end
TEST(Absolute, OverTheEnd) {
  Bench b = bench(10'000);
  b.job(1, 9000);
  b.command.motion = motion(2000, 5000, {500, 100});
  b.run(5, &Command::plus, 300);
  b.untilSet(&Image::changedOver);
  EXPECT_NEAR(b.image().position, 9804, 4);
  b.untilSet(&Image::cutOff);
  EXPECT_NEAR(b.image().position, 202, 2);
  b.untilStands();
  EXPECT_TRUE(b.image().positionReached);
}

}  // namespace
}  // namespace merker::positioning
