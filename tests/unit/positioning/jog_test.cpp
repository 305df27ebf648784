// Jog mode (technology manual 3.4.3, 4.4.3; POS-JOG).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

class Jogging : public Bench {
 public:
  explicit Jogging(const io::AxisChannel& parameters = analogAxis()) : Bench(parameters) {
    command.motion = motion(5000, 5000);
    command.mode = 1;
  }
  std::uint16_t levels(bool plus, bool minus) {
    command.plus = plus;
    command.minus = minus;
    return call();
  }
  std::int64_t setPoint() const { return channel.outputs().setPoint; }
};

// POS-JOG-01, POS-JOG-04, POS-JOG-07, POS-JOG-08: the whole sequence of signals
TEST(Jog, Signals) {
  Jogging b;
  ASSERT_EQ(b.levels(true, false), kNoError);
  EXPECT_TRUE(b.image().working);
  EXPECT_TRUE(b.image().rampUp);
  EXPECT_EQ(static_cast<int>(b.image().mode), 1);
  b.cycle();
  EXPECT_TRUE(b.channel.outputs().enable);
  EXPECT_EQ(b.setPoint(), 20'000);
  b.cycles(249);
  EXPECT_EQ(b.setPoint(), 5'000'000);
  EXPECT_FALSE(b.image().rampUp);
  EXPECT_TRUE(b.image().startEnabled);
  b.levels(false, false);
  b.cycle();
  EXPECT_EQ(b.setPoint(), 4'980'000);
  EXPECT_TRUE(b.image().rampDown);
  b.cycles(249);
  EXPECT_EQ(b.setPoint(), 0);
  EXPECT_TRUE(b.image().working);
  b.cycle();
  EXPECT_FALSE(b.image().working);
  EXPECT_FALSE(b.image().rampDown);
  EXPECT_FALSE(b.channel.outputs().enable);
  EXPECT_FALSE(b.image().positionReached);
  EXPECT_FALSE(b.image().cutOff);
}

// POS-JOG-02, POS-JOG-06, POS-END-02: plus, both, minus; working and enabled over the reversal
TEST(Jog, ChangeOfDirection) {
  Jogging b;
  b.levels(true, false);
  b.cycles(300);
  EXPECT_EQ(b.levels(true, true), kNoError);
  b.cycles(10);
  EXPECT_EQ(b.setPoint(), 4'800'000);
  b.levels(false, true);
  b.watch = [&] { EXPECT_TRUE(b.image().working && b.channel.outputs().enable); };
  b.until([&] { return b.setPoint() == 0; });
  b.cycle();
  EXPECT_EQ(b.setPoint(), -20'000);
}

// A direction that is wanted again while it ramps down is taken on at once.
TEST(Jog, TakesOnWhileRampingDown) {
  Jogging b;
  b.levels(true, false);
  b.cycles(300);
  b.levels(false, false);
  b.cycles(10);
  b.command.motion.speed = 2000;  // POS-JOG-14
  b.levels(true, false);
  b.cycle();
  EXPECT_EQ(b.setPoint(), 4'780'000);
  b.cycles(200);
  EXPECT_EQ(b.setPoint(), 2'000'000);
}

// POS-JOG-03, POS-ERR-04, POS-END-10: after STOP and after an error a new edge is needed
TEST(Jog, NeedsAnEdge) {
  Jogging b;
  b.levels(true, false);
  b.cycles(100);
  b.command.stop = true;
  b.call();
  EXPECT_FALSE(b.image().startEnabled);
  b.untilReset(&Image::working);
  b.command.stop = false;
  b.call();
  b.cycles(10);
  EXPECT_FALSE(b.image().working);
  b.levels(false, false);
  EXPECT_EQ(b.levels(true, false), kNoError);
  EXPECT_TRUE(b.image().working);
  b.levels(false, false);
  b.untilReset(&Image::working);
  b.command.motion.speed = 5;
  EXPECT_EQ(b.levels(true, false), 0x3202);
  b.command.motion.speed = 5000;
  EXPECT_EQ(b.call(), 0x3202);
  EXPECT_FALSE(b.image().working);
}

// A level that lasts while another mode is set is no change when jog mode comes back.
TEST(Jog, LevelsOfOtherModesDoNotCount) {
  Jogging b;
  b.command.mode = 4;
  b.command.target = 1000;
  b.levels(true, false);
  b.untilReset(&Image::working);
  b.command.mode = 1;
  b.call();
  EXPECT_FALSE(b.image().working);
}

// POS-JOG-10, POS-RUN-39: at a limit it ends like a run to a target
TEST(Jog, EndsAtTheSoftwareLimit) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -20'000;
  p.highLimit = 20'000;
  Jogging b(p);
  ASSERT_EQ(b.job(1, 0), kNoError);
  b.levels(true, false);
  b.untilSet(&Image::changedOver);
  EXPECT_GE(b.image().position, 19'000);
  b.untilReset(&Image::working);
  EXPECT_TRUE(b.image().cutOff);
  b.untilStands();
  EXPECT_LE(b.image().position, 20'003);
  EXPECT_GE(b.image().position, 20'000);
  EXPECT_FALSE(b.image().positionReached);
}

// POS-JOG-11, POS-ERR-41, POS-ERR-42
TEST(Jog, LimitTooClose) {
  for (const bool plus : {true, false}) {
    for (const std::int32_t away : {50, 100, 101}) {
      io::AxisChannel p = analogAxis();
      p.lowLimit = -1000;
      p.highLimit = 1000;
      Jogging b(p);
      b.job(1, plus ? 1000 - away : away - 1000);
      const int refused = plus ? 0x3505 : 0x3506;
      EXPECT_EQ(b.levels(plus, !plus), away > 100 ? 0 : refused) << away;
    }
  }
}

// POS-JOG-10: rotary axes have no end
TEST(Jog, RotaryIsEndless) {
  io::AxisChannel p = analogAxis();
  p.rotary = true;
  p.rotaryEnd = 1000;
  Jogging b(p);
  b.job(1, 0);
  b.levels(true, false);
  int turns = 0, last = 0;
  b.watch = [&] {
    const int now = b.image().position;
    EXPECT_TRUE(now >= 0 && now < 1000);  // POS-PARAM-17
    turns += now < last ? 1 : 0;
    last = now;
  };
  b.cycles(2500);
  EXPECT_TRUE(b.image().working);
  EXPECT_GE(turns, 40);
  b.levels(false, true);
  b.cycles(3000);
  EXPECT_TRUE(b.image().down);
}

// POS-JOG-13, POS-OPEN-21
TEST(Jog, NextRelativeRunBeginsWhereItStopped) {
  Jogging b;
  b.levels(true, false);
  b.cycles(300);
  EXPECT_EQ(b.image().lastTarget, b.image().position);
  EXPECT_EQ(b.image().distanceToGo, 0);
  b.levels(false, false);
  b.untilReset(&Image::working);
  const std::int32_t stopped = b.image().position;
  b.run(4, &Command::plus, 1000);
  EXPECT_EQ(b.image().lastTarget, stopped + 1000);
}

}  // namespace
}  // namespace merker::positioning
