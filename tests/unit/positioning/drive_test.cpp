// The analog output: scaling, signs, runs without creep speed (POS-RUN-13, -17 to -19, -23), and
// the parameters of the axis that the CPU refuses (POS-PARAM).
#include <gtest/gtest.h>

#include "bench.h"
#include "positioning/soundness.h"

namespace merker::positioning {
namespace {

// POS-RUN-18, POS-RUN-19, POS-PARAM-05, POS-PARAM-06, POS-PARAM-10
TEST(AnalogOutput, Scaling) {
  for (const bool plus : {true, false}) {
    Bench b(analogAxis());
    b.command.motion = motion(1000, 100'000);
    b.run(4, plus ? &Command::plus : &Command::minus, 5000);
    b.cycles(100);
    EXPECT_EQ(b.channel.analogValue(), plus ? 2765 : -2765);
    EXPECT_FALSE(b.channel.outputs().direction);
  }
  Bench full(analogAxis());
  full.command.motion = motion(10'000, 100'000);
  full.run(4, &Command::plus, 50'000);
  full.cycles(100);
  EXPECT_EQ(full.channel.analogValue(), 27'648);
}

// POS-RUN-17: the direction changes where the set-point was 0
TEST(AnalogOutput, DirectionSignal) {
  io::AxisChannel p = analogAxis();
  p.analogControl = io::AnalogControl::WithDirection;
  plant::AxisSettings settings;
  settings.section = plant::PowerSection::WithDirection;
  Bench b(p, settings);
  b.command.motion = quick();
  std::int64_t before = 0;
  bool direction = false;
  b.watch = [&] {
    const Outputs& outputs = b.channel.outputs();
    EXPECT_GE(outputs.setPoint, 0);
    EXPECT_TRUE(outputs.direction == direction || before == 0);
    EXPECT_TRUE(outputs.enable || !outputs.direction);
    before = outputs.setPoint;
    direction = outputs.direction;
  };
  b.command.minus = true;
  b.call();
  b.cycles(100);
  EXPECT_TRUE(b.channel.outputs().direction);
  EXPECT_TRUE(b.image().down);
  b.command.minus = false;
  b.command.plus = true;
  b.call();
  b.cycles(100);
  EXPECT_FALSE(b.channel.outputs().direction);
  EXPECT_FALSE(b.image().down);
}

// POS-RUN-13, POS-OPEN-13: the set-point falls to 0 up to the cut-off point, without creep speed
TEST(AnalogOutput, WithoutCreepSpeed) {
  Bench b(analogAxis());
  b.command.motion = motion(5000, 5000, {50, 100});
  ASSERT_EQ(b.run(4, &Command::plus, 20'000), kNoError);
  std::int64_t before = 0;
  bool falling = false;
  b.watch = [&] {
    const std::int64_t now = b.channel.outputs().setPoint;
    EXPECT_TRUE(!falling || before == 0 || before - now == 20'000);
    falling = falling || now < before;
    before = now;
  };
  b.untilSet(&Image::rampDown);
  EXPECT_EQ(b.axis.pulse(), 17'400);
  b.until([&] { return b.channel.outputs().setPoint == 0; });
  EXPECT_TRUE(b.image().working);
  EXPECT_TRUE(b.channel.outputs().enable);
  b.cycle();
  EXPECT_FALSE(b.image().working);
  EXPECT_TRUE(b.image().cutOff);
  EXPECT_FALSE(b.channel.outputs().enable);
  EXPECT_EQ(b.axis.pulse(), 19'900);
}

// POS-RUN-05: the points of each direction
TEST(AnalogOutput, DifferencesOfEachDirection) {
  Bench b(analogAxis());
  b.command.motion = motion(1000, 100'000);
  b.command.motion.differences = {{2000, 200}, {500, 50}};
  b.run(4, &Command::plus, 5000);
  b.untilSet(&Image::changedOver);
  EXPECT_NEAR(b.image().position, 3000, 4);
  b.untilSet(&Image::cutOff);
  EXPECT_NEAR(b.image().position, 4800, 4);
  b.untilStands();
  b.run(4, &Command::minus, 5000);
  b.untilSet(&Image::changedOver);
  EXPECT_NEAR(b.image().position, 500, 4);
  b.untilSet(&Image::cutOff);
  EXPECT_NEAR(b.image().position, 50, 4);
}

// POS-RUN-23: what changes during a run takes effect with the next one
TEST(AnalogOutput, ParametersOfARunAreFixed) {
  Bench b(analogAxis());
  b.command.motion = motion(2000, 100'000);
  b.run(4, &Command::plus, 50'000);
  b.cycles(100);
  b.command.motion = motion(9000, 100, {10'000, 5000});
  b.call();
  b.cycles(100);
  EXPECT_EQ(b.channel.outputs().setPoint, 2'000'000);
  b.untilSet(&Image::changedOver);
  EXPECT_NEAR(b.image().position, 49'000, 8);
}

// POS-PARAM-02, POS-PARAM-03, POS-PARAM-04, POS-PARAM-05, POS-PARAM-06, POS-PARAM-07, POS-PARAM-08,
// POS-PARAM-09, POS-PARAM-11, POS-PARAM-16, POS-PARAM-17, POS-PARAM-19, POS-PARAM-24
TEST(Parameters, AreRefused) {
  using io::AxisChannel;
  EXPECT_FALSE(flaw(AxisChannel{}));
  const auto refused = [](auto change) {
    AxisChannel p = analogAxis();
    change(p);
    return flaw(p).has_value();
  };
  EXPECT_TRUE(refused([](AxisChannel& p) { p.targetRange = 200'000'001; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.targetRange = -1; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.monitoringTime = 100'001; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.highestSpeed = 9; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.highestSpeed = 1'000'001; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.creepSpeed = 10'001; }));
  EXPECT_FALSE(refused([](AxisChannel& p) { p.creepSpeed = 10'000; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.cutOffDelay = 100'001; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.maxFrequency = 20; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.accompanyingFrequency = 0; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.digitalControl = 5; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.highLimit = 500'000'001; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.lowLimit = p.highLimit; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.reference = p.highLimit + 1; }));
  EXPECT_FALSE(refused([](AxisChannel& p) { p.reference = p.highLimit; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.increments = 0; }));
  EXPECT_TRUE(refused([](AxisChannel& p) { p.increments = (1 << 23) + 1; }));
  const auto between = [&](std::int32_t limit, std::int32_t range) {
    return refused([&](AxisChannel& p) {
      p.lowLimit = -limit;
      p.highLimit = limit;
      p.targetRange = range;
    });
  };
  EXPECT_TRUE(between(0, 0));
  EXPECT_FALSE(between(100, 200));
  EXPECT_TRUE(between(100, 201));
  const auto round = [&](std::int32_t end, std::int32_t reference, std::int32_t range) {
    return refused([&](AxisChannel& p) {
      p.rotary = true;
      p.rotaryEnd = end;
      p.reference = reference;
      p.targetRange = range;
    });
  };
  EXPECT_FALSE(round(100, 99, 100));
  EXPECT_TRUE(round(100, 100, 100));
  EXPECT_TRUE(round(100, -1, 100));
  EXPECT_TRUE(round(100, 0, 101));
  EXPECT_TRUE(round(0, 0, 0));
  EXPECT_TRUE(round(1'000'000'001, 0, 0));
}

}  // namespace
}  // namespace merker::positioning
