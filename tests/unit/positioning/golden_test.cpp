// The golden runs of the requirements, to the pulse and to the cycle: A1 to A3 with the analog
// output, D1 and D2 with the digital ones, R1 to R3 to the reference point.
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

constexpr std::int64_t kMillionths = 1'000'000;

// POS-RUN-30, POS-RUN-04, POS-RUN-06, POS-RUN-08, POS-RUN-09, POS-RUN-10, POS-PLANT-02,
// POS-PLANT-03, POS-PLANT-04, POS-PLANT-19
TEST(Golden, A1) {
  Bench b(analogAxis());
  b.command.motion = motion(10'000, 1000);
  ASSERT_EQ(b.run(4, &Command::plus, 200'000), kNoError);
  EXPECT_TRUE(b.image().rampUp);
  EXPECT_EQ(b.untilReset(&Image::rampUp), 2499);
  EXPECT_EQ(b.untilSet(&Image::rampDown), 4988);
  EXPECT_EQ(b.axis.position(), 149'520 * kMillionths);
  EXPECT_EQ(b.untilSet(&Image::changedOver), 7234);
  EXPECT_EQ(b.axis.position(), 199'003'872'000);
  EXPECT_FALSE(b.image().rampDown);
  EXPECT_EQ(b.channel.outputs().setPoint, 1'000'000);
  EXPECT_EQ(b.untilReset(&Image::working), 7459);
  EXPECT_EQ(b.axis.position(), 199'903'904'000);
  EXPECT_TRUE(b.image().cutOff);
  EXPECT_EQ(b.channel.outputs().setPoint, 0);
  EXPECT_FALSE(b.channel.outputs().enable);
  EXPECT_EQ(b.untilSet(&Image::positionReached), 7483);
  EXPECT_EQ(b.untilStands(), 7509);
  EXPECT_EQ(b.axis.position(), 200'003'904'000);
  EXPECT_EQ(b.image().position, 200'003);
  EXPECT_EQ(b.image().distanceToGo, -3);
}

// POS-RUN-14
TEST(Golden, A2) {
  Bench b(analogAxis());
  b.command.motion = motion(10'000, 1000);
  b.run(4, &Command::plus, 20'000);
  EXPECT_EQ(b.until([&] { return !b.image().rampUp && b.image().rampDown; }), 1104);
  EXPECT_EQ(b.channel.outputs().setPoint, 4'416'000 - 4000);
  EXPECT_EQ(b.untilSet(&Image::changedOver), 1958);
  EXPECT_EQ(b.untilSet(&Image::cutOff), 2183);
}

// POS-RUN-15
TEST(Golden, A3) {
  Bench b(analogAxis());
  b.command.motion = motion(10'000, 1000);
  b.run(4, &Command::plus, 800);
  EXPECT_TRUE(b.image().changedOver);
  b.watch = [&] { EXPECT_LE(b.channel.outputs().setPoint, 1'000'000); };
  EXPECT_EQ(b.untilSet(&Image::cutOff), 300);
  EXPECT_EQ(b.axis.pulse(), 700);
}

// POS-RUN-21, POS-RUN-31, POS-PLANT-08, POS-DIGCTRL-09
TEST(Golden, D1) {
  Bench b(digitalAxis(), contactors());
  b.command.motion = rapid({3000, 100});
  b.run(4, &Command::plus, 20'000);
  b.cycle();
  EXPECT_EQ(b.channel.outputs().digital, 0b0101);
  EXPECT_EQ(b.untilSet(&Image::changedOver), 488);
  EXPECT_EQ(b.axis.position(), 17'020 * kMillionths);
  EXPECT_EQ(b.channel.outputs().digital, 0b0110);
  EXPECT_EQ(b.until([&] { return b.axis.speed() == 1'000'000; }), 601);
  EXPECT_EQ(b.untilReset(&Image::working), 702);
  EXPECT_EQ(b.axis.position(), 19'901'040'000);
  EXPECT_EQ(b.channel.outputs().digital, 0);
  EXPECT_TRUE(b.image().cutOff);
  EXPECT_EQ(b.untilSet(&Image::positionReached), 727);
  EXPECT_EQ(b.untilStands(), 752);
  EXPECT_EQ(b.axis.position(), 20'001'040'000);
}

// POS-RUN-12, POS-RUN-32, POS-RUN-42: a changeover difference that is too small is no error, but
// the axis overruns the target.
TEST(Golden, D2) {
  Bench b(digitalAxis(), contactors());
  b.command.motion = rapid({1000, 100});
  EXPECT_EQ(b.run(4, &Command::plus, 20'000), kNoError);
  EXPECT_EQ(b.untilSet(&Image::changedOver), 538);
  EXPECT_EQ(b.axis.position(), 19'020 * kMillionths);
  EXPECT_EQ(b.untilSet(&Image::cutOff), 563);
  EXPECT_EQ(b.axis.position(), 19'920 * kMillionths);
  EXPECT_EQ(b.axis.speed(), 8'000'000);
  EXPECT_EQ(b.untilStands(), 963);
  EXPECT_EQ(b.axis.position(), 26'320 * kMillionths);
  EXPECT_EQ(b.image().distanceToGo, -6320);
  EXPECT_TRUE(b.image().positionReached);
  EXPECT_EQ(b.call(), kNoError);
}

// POS-END-04, POS-OPEN-14: D1 with STOP, served by cycle 300.
TEST(Golden, DigitalStop) {
  Bench b(digitalAxis(), contactors());
  b.command.motion = rapid({3000, 100});
  b.run(4, &Command::plus, 20'000);
  b.cycles(300);
  b.command.stop = true;
  b.call();
  b.cycle();
  EXPECT_EQ(b.number, 300);
  EXPECT_EQ(b.axis.pulse(), 9500);
  EXPECT_EQ(b.channel.outputs().digital, 0b0110);
  EXPECT_EQ(b.untilReset(&Image::working), 519);
  EXPECT_EQ(b.axis.position(), 12'401'040'000);
  b.untilStands();
  EXPECT_EQ(b.axis.position(), 12'501'040'000);
  EXPECT_EQ(b.image().distanceToGo, 20'000 - 12'501);
}

Bench reference(std::int64_t pulse, bool below) {
  io::AxisChannel p = analogAxis();
  p.reference = 500;
  p.referenceBelowSwitch = below;
  Bench b(p, {}, pulse);
  b.command.motion = motion(5000, 5000);
  return b;
}

// POS-REF-05, POS-REF-14, POS-PLANT-13, POS-PLANT-14, POS-END-03: the switch ahead, the mark behind
// it
TEST(Golden, R1) {
  Bench b = reference(10'000, false);
  ASSERT_EQ(b.run(3, &Command::plus), kNoError);
  EXPECT_TRUE(b.image().working);
  EXPECT_FALSE(b.image().synchronous);
  EXPECT_EQ(b.untilSet(&Image::rampDown), 1140);
  EXPECT_EQ(b.axis.pulse(), 30'300);
  EXPECT_EQ(b.until([&] { return !b.axis.onReference(); }), 1990);
  EXPECT_EQ(b.axis.pulse(), 35'300);
  EXPECT_EQ(b.untilSet(&Image::synchronous), 2165);
  EXPECT_EQ(b.axis.pulse(), 36'000);
  EXPECT_EQ(b.image().position, 500);
  EXPECT_EQ(b.untilReset(&Image::working), 2215);
  EXPECT_FALSE(b.channel.outputs().enable);
  EXPECT_EQ(b.image().position, 600);
  EXPECT_EQ(b.image().lastTarget, 600);
}

// POS-REF-06: over the switch and back
TEST(Golden, R2) {
  Bench b = reference(10'000, true);
  b.run(3, &Command::plus);
  EXPECT_EQ(b.untilSet(&Image::rampDown), 1140);
  EXPECT_EQ(b.until([&] { return b.channel.outputs().setPoint < 0; }), 1390);
  EXPECT_EQ(b.axis.pulse(), 32'800);
  EXPECT_TRUE(b.image().working);
  EXPECT_EQ(b.until([&] { return !b.axis.onReference(); }), 2041);
  EXPECT_EQ(b.untilSet(&Image::synchronous), 2115);
  EXPECT_EQ(b.axis.position(), 30'000 * kMillionths);
  EXPECT_EQ(b.untilReset(&Image::working), 2165);
  EXPECT_EQ(b.image().position, 400);
}

// POS-REF-07: from the switch, against the direction of the start
TEST(Golden, R3) {
  Bench b = reference(33'000, false);
  b.run(3, &Command::minus);
  EXPECT_EQ(b.until([&] { return !b.axis.onReference(); }), 600);
  EXPECT_EQ(b.untilSet(&Image::synchronous), 775);
  EXPECT_EQ(b.axis.pulse(), 36'000);
  EXPECT_EQ(b.untilReset(&Image::working), 825);
  EXPECT_EQ(b.image().position, 600);
}

}  // namespace
}  // namespace merker::positioning
