// The ends of a run: ramping down and aborting (technology manual 3.4.1; POS-END).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

Bench bench(io::AxisChannel p = analogAxis()) {
  Bench b(p);
  b.command.motion = quick();
  b.job(1, 0);
  return b;
}

// POS-END-05, POS-END-06, POS-END-07, POS-RUN-20, POS-RUN-38, POS-PARAM-07, POS-RUN-16
TEST(Ends, AbortByTheDriveEnable) {
  for (const auto& [delay, cycles] : {std::pair{1000, 250}, {0, 0}, {5, 2}}) {
    io::AxisChannel p = analogAxis();
    p.cutOffDelay = delay;
    Bench b = bench(p);
    b.run(4, &Command::plus, 100'000);
    b.cycles(500);
    b.command.driveEnable = false;
    b.call();
    EXPECT_FALSE(b.image().working);
    EXPECT_EQ(b.image().distanceToGo, 0);
    EXPECT_FALSE(b.image().startEnabled);
    EXPECT_NE(b.channel.outputs().setPoint, 0);  // until the next cycle
    b.cycle();
    EXPECT_EQ(b.channel.outputs().setPoint, 0);
    const int first = b.number;
    while (b.channel.outputs().enable) b.cycle();
    EXPECT_EQ(b.number, first + cycles);
    EXPECT_FALSE(b.image().positionReached);
    b.command.driveEnable = true;
    const std::int32_t last = b.image().lastTarget;
    b.run(4, &Command::plus, 50'000);
    EXPECT_EQ(b.image().lastTarget, last + 50'000);
  }
}

// POS-END-09, POS-OPEN-24
TEST(Ends, StartDuringTheCutOffDelay) {
  Bench b = bench();
  b.run(4, &Command::plus, 100'000);
  b.cycles(100);
  b.command.driveEnable = false;
  b.call();
  b.cycles(50);
  b.command.driveEnable = true;
  b.run(4, &Command::plus, 100'000);
  b.watch = [&] { EXPECT_TRUE(b.channel.outputs().enable); };
  b.cycles(1000);
}

// POS-END-08, POS-END-05, POS-ENC-11: the CPU goes to STOP
TEST(Ends, CpuStops) {
  Bench b = bench();
  b.run(4, &Command::plus, 100'000);
  b.cycles(500);
  b.channel.stop();
  EXPECT_EQ(b.channel.outputs().setPoint, 0);
  EXPECT_TRUE(b.channel.outputs().enable);
  EXPECT_FALSE(b.image().working);
  const std::int32_t position = b.image().position;
  b.cycles(251);
  EXPECT_FALSE(b.channel.outputs().enable);
  EXPECT_GT(b.image().position, position);
  Bench digital(digitalAxis(), contactors());
  digital.command.motion = rapid({3000, 100});
  digital.run(4, &Command::plus, 20'000);
  digital.cycles(10);
  digital.channel.stop();
  EXPECT_EQ(digital.channel.outputs().digital, 0);
}

// POS-END-01, POS-END-02, POS-END-03: 50 000 pulses in 10 s
TEST(Ends, AnalogStop) {
  Bench b(analogAxis());
  b.command.motion = motion(10'000, 1000);
  b.run(4, &Command::plus, 200'000);
  b.until([&] { return b.axis.speed() == 10'000'000; });
  b.command.stop = true;
  b.call();
  b.cycle();
  const int first = b.number;
  const std::int64_t position = b.axis.position();
  EXPECT_EQ(b.untilReset(&Image::working), first + 2500);
  EXPECT_EQ(b.axis.position() - position, 50'000'000'000);
}

// A run that ramps down ends at its cut-off point if that comes first.
TEST(Ends, StopNearTheCutOffPoint) {
  Bench b = bench();
  b.command.motion = motion(10'000, 10'000);
  b.run(4, &Command::plus, 5000);
  b.until([&] { return b.image().position >= 4870; });
  b.command.stop = true;
  b.call();
  b.cycle();
  EXPECT_TRUE(b.image().working);
  b.untilReset(&Image::working);
  EXPECT_TRUE(b.image().cutOff);
  EXPECT_NEAR(b.image().position, 4900, 4);
}

// POS-RUN-13: without creep speed it goes on until the set-point is 0.
TEST(Ends, StopWithoutCreepSpeed) {
  Bench b = bench();
  b.command.motion = motion(10'000, 100'000, {184, 249});
  b.command.motion.deceleration = 1000;
  b.run(4, &Command::plus, 1650);
  b.cycles(6);
  b.command.stop = true;
  b.call();
  b.until([&] { return b.image().position > 1650 - 249; });
  EXPECT_TRUE(b.image().working);
  EXPECT_GT(b.channel.outputs().setPoint, 0);
  b.untilReset(&Image::working);
  EXPECT_FALSE(b.image().cutOff);
}

// POS-END-11: behind the cut-off point STOP changes nothing
TEST(Ends, StopWhileCoasting) {
  Bench b = bench();
  b.run(4, &Command::plus, 5000);
  b.untilReset(&Image::working);
  b.command.stop = true;
  b.call();
  EXPECT_GE(b.untilSet(&Image::positionReached), 0);
}

// POS-OPEN-27
TEST(Ends, NoStartWhileRampingDown) {
  Bench b(analogAxis());
  b.command.motion = motion(10'000, 1000);
  b.run(4, &Command::plus, 200'000);
  b.cycles(1000);
  b.command.stop = true;
  b.call();
  b.command.stop = false;
  b.cycle();
  EXPECT_EQ(b.press(&Command::plus), 0x3104);
}

}  // namespace
}  // namespace merker::positioning
