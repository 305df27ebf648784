// Monitoring (technology manual 3.4.1, 3.6.1; POS-MON).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

Bench bench(io::AxisChannel p = analogAxis(), plant::AxisSettings settings = {}) {
  Bench b(p, settings);
  b.command.motion = quick();
  b.job(1, 0);
  return b;
}

io::AxisChannel with(bool io::AxisMonitors::*monitor) {
  io::AxisChannel p = analogAxis();
  p.monitors.*monitor = true;
  return p;
}

// POS-MON-08, POS-PARAM-04, POS-MON-09: 2000 ms after the last pulse, rounded up to 4 ms
TEST(Monitoring, BlockedAxis) {
  for (const auto& [time, cycles] : {std::pair{2000, 500}, {2001, 501}, {4, 1}})
    for (const auto direction : {&Command::plus, &Command::minus}) {
      io::AxisChannel p = analogAxis();
      p.monitoringTime = time;
      plant::AxisSettings settings;
      settings.lowSwitch = -100'000;
      Bench b = bench(p, settings);
      b.run(4, direction, 100'000);
      b.cycles(250);
      b.axis.faults.blocked = true;
      const int last = b.number;
      EXPECT_EQ(b.untilError(kMovement), last + cycles);
      EXPECT_FALSE(b.image().working);
    }
  io::AxisChannel off = analogAxis();
  off.monitoringTime = 0;
  Bench b = bench(off);
  b.axis.faults.blocked = true;
  b.run(4, &Command::plus, 100'000);
  b.cycles(100'000);
  EXPECT_TRUE(b.image().working);
}

// POS-MON-10, POS-RUN-29: swapped tracks are a movement in the wrong direction
TEST(Monitoring, SwappedTracks) {
  Bench b = bench();
  b.axis.faults.swapped = true;
  b.run(4, &Command::plus, 100'000);
  b.cycles(20);
  EXPECT_TRUE(b.image().down);
  EXPECT_EQ(b.untilError(kMovement), 500);
  io::AxisChannel p = analogAxis();
  p.inverted = true;  // POS-PARAM-25, POS-ENC-05
  Bench inverted = bench(p);
  inverted.axis.faults.swapped = true;
  inverted.run(4, &Command::plus, 5000);
  inverted.untilSet(&Image::positionReached);
  EXPECT_EQ(inverted.image().errors, 0);
}

// POS-WIRE-11: a broken track is seen by the monitoring only
TEST(Monitoring, BrokenTrack) {
  for (const bool monitored : {true, false}) {
    io::AxisChannel p = analogAxis();
    p.monitors.movement = monitored;
    plant::AxisSettings settings;
    settings.highSwitch = 100'000'000;
    Bench b = bench(p, settings);
    b.run(4, &Command::plus, 5000);
    b.axis.faults.trackBroken = true;
    b.cycles(5000);
    EXPECT_EQ(b.image().working, !monitored);
    EXPECT_EQ(b.image().errors, monitored ? kMovement : 0);
  }
}

// POS-RUN-41, POS-PLANT-06: the drive moves from 0.5 V on, half a second after the start
TEST(Monitoring, Stiction) {
  for (const int time : {400, 600}) {
    io::AxisChannel p = analogAxis();
    p.monitoringTime = time;
    plant::AxisSettings settings;
    settings.stiction = 500'000'000;
    Bench b = bench(p, settings);
    b.command.motion = motion(10'000, 1000);
    b.run(4, &Command::plus, 5000);
    b.cycles(200);
    EXPECT_EQ(b.image().errors, time == 400 ? kMovement : 0);
  }
}

// POS-OPEN-18, POS-MON-05, POS-MON-06, POS-JOG-12, POS-PARAM-16, POS-PARAM-23, POS-MON-17
TEST(Monitoring, WorkingRange) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -1000;
  p.highLimit = 1000;
  Bench b = bench(p);
  b.job(1, 1000);
  b.cycles(2);
  EXPECT_EQ(b.image().errors, 0);
  b.channel.move(1);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange);
  EXPECT_TRUE(b.image().synchronous);
  EXPECT_EQ(b.run(4, &Command::minus, 500), 0x3105);
  b.acknowledge();
  b.cycles(10);
  EXPECT_EQ(b.image().errors, 0);
  EXPECT_EQ(b.run(4, &Command::minus, 500), 0x3008);
  EXPECT_EQ(b.run(5, &Command::start, 0), 0x3008);
  b.command.mode = 1;
  EXPECT_EQ(b.press(&Command::plus), 0x3505);
  b.command.minus = true;
  EXPECT_EQ(b.call(), kNoError);
  b.until([&] { return b.image().position < 900; });
  EXPECT_EQ(b.image().errors, 0);
  b.command.minus = false;
  b.call();
  b.untilStands();
  b.channel.move(2000);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange);
}

// POS-PARAM-23: only with a synchronised axis, and not on a rotary one
TEST(Monitoring, NoWorkingRange) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -1000;
  p.highLimit = 1000;
  Bench unsynchronised(p);
  unsynchronised.channel.move(5000);
  unsynchronised.cycle();
  EXPECT_EQ(unsynchronised.image().errors, 0);
  p.rotary = true;
  Bench round = bench(p);
  round.channel.move(5000);
  round.cycle();
  EXPECT_EQ(round.image().errors, 0);
}

// POS-MON-07, POS-OPEN-10, POS-MON-15
TEST(Monitoring, TravelRange) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -500'000'000;
  p.highLimit = 500'000'000;
  p.monitors.workingRange = false;
  Bench b = bench(p);
  EXPECT_EQ(b.image().errors, 0);
  b.job(1, 500'000'000);
  b.cycle();
  EXPECT_EQ(b.image().errors, 0);
  b.channel.move(1);
  b.cycle();
  EXPECT_EQ(b.image().errors, kTravelRange);
  EXPECT_FALSE(b.image().synchronous);
}

// POS-MON-02, POS-MON-03, POS-ERR-54
TEST(Monitoring, MissingPulse) {
  Bench b = bench(with(&io::AxisMonitors::missingPulse));
  b.run(4, &Command::plus, 50'000);
  b.until([&] { return b.axis.pulse() > 10'500; });
  b.axis.faults.lost = 4;
  b.untilError(kMissingPulse);
  EXPECT_NEAR(static_cast<double>(b.axis.pulse()), 12'000, 45);
  EXPECT_FALSE(b.image().synchronous);
  EXPECT_FALSE(b.image().working);
  EXPECT_EQ(b.image().distanceToGo, 0);
}

// POS-MON-03, POS-PARAM-26, POS-OPEN-20: parameters that are wrong, no marks at all, one mark again
// and again
TEST(Monitoring, NoMissingPulse) {
  for (const std::int32_t increments : {1000, 3}) {
    io::AxisChannel p = with(&io::AxisMonitors::missingPulse);
    p.increments = increments;
    Bench b = bench(p);
    b.run(4, &Command::plus, 20'000);
    b.untilReset(&Image::working);
    EXPECT_EQ(b.image().errors, 0);
    if (increments == 3) b.axis.faults.lost = 3;  // 12 pulses: not monitored
    b.run(4, &Command::minus, 20'000);
    b.untilReset(&Image::working);
    EXPECT_EQ(b.image().errors, 0);
  }
  Bench broken = bench(with(&io::AxisMonitors::missingPulse));
  broken.axis.faults.markBroken = true;
  broken.run(4, &Command::plus, 20'000);
  broken.untilReset(&Image::working);
  EXPECT_EQ(broken.image().errors, 0);
  Bench b = bench(with(&io::AxisMonitors::missingPulse));
  for (int i = 0; i < 5; ++i) {
    b.run(4, &Command::plus, 500);
    b.untilReset(&Image::working);
    b.run(4, &Command::minus, 500);
    b.untilReset(&Image::working);
    EXPECT_EQ(b.image().errors, 0);
  }
}

// POS-MON-11, POS-PARAM-13: the axis stops short of the target
TEST(Monitoring, TargetApproach) {
  Bench b = bench(with(&io::AxisMonitors::approach));
  b.command.motion = motion(1000, 100'000, {1000, 500});
  b.run(4, &Command::plus, 5000);
  const int cutOff = b.untilSet(&Image::cutOff);
  EXPECT_EQ(b.untilError(kTargetApproach), cutOff + 500);
  EXPECT_NEAR(b.image().distanceToGo, 400, 4);
  EXPECT_EQ(b.image().lastTarget, 5000);
  EXPECT_TRUE(b.image().synchronous);
  EXPECT_FALSE(b.image().positionReached);
}

// POS-MON-12
TEST(Monitoring, NextRunEndsTheApproach) {
  Bench b = bench(with(&io::AxisMonitors::approach));
  b.command.motion = motion(1000, 100'000, {1000, 500});
  b.run(4, &Command::plus, 5000);
  b.untilSet(&Image::cutOff);
  b.cycles(25);
  EXPECT_EQ(b.run(4, &Command::plus, 20'000), kNoError);
  b.cycles(1000);
  EXPECT_EQ(b.image().errors, 0);
}

// POS-MON-13, POS-MON-14, POS-PARAM-02, POS-PARAM-14, POS-PLANT-16, POS-RUN-10
TEST(Monitoring, TargetRange) {
  for (const auto& [range, drift, rest] :
       {std::tuple{50, 10, -26}, {51, 10, -27}, {50, -10, 26}, {51, -10, 27}}) {
    io::AxisChannel p = with(&io::AxisMonitors::targetRange);
    p.targetRange = range;
    plant::AxisSettings settings;
    settings.drift = drift;
    Bench b = bench(p, settings);
    b.run(4, &Command::plus, 5000);
    b.untilSet(&Image::positionReached);
    b.untilError(kTargetRange);
    EXPECT_EQ(b.image().distanceToGo, rest);
    EXPECT_TRUE(b.image().positionReached);
    EXPECT_EQ(b.image().lastTarget, 5000);
    b.acknowledge();
    b.cycles(1000);
    EXPECT_EQ(b.image().errors, 0);
  }
}

// POS-RUN-11, POS-RUN-12
TEST(Monitoring, TargetRangeOfZero) {
  io::AxisChannel p = with(&io::AxisMonitors::targetRange);
  p.targetRange = 0;
  for (const std::int32_t cutOff : {90, 115}) {
    Bench b = bench(p);
    b.command.motion = motion(1000, 100'000, {1000, cutOff});
    b.run(4, &Command::plus, 5000);
    b.untilReset(&Image::working);
    b.untilStands();
    b.cycle();
    EXPECT_EQ(b.image().positionReached, cutOff < 100);
    EXPECT_EQ(b.image().errors, cutOff < 100 ? kTargetRange : 0);
  }
}

// POS-RUN-12: a target that is passed within a cycle has been reached, wherever the axis is at its
// end.
TEST(Monitoring, TargetPassedWithinACycle) {
  io::AxisChannel p = with(&io::AxisMonitors::approach);
  p.targetRange = 0;
  Bench b = bench(p);
  b.command.motion = motion(1000, 100'000, {1000, 500});
  b.run(4, &Command::plus, 5000);
  b.untilSet(&Image::cutOff);
  b.untilStands();
  EXPECT_FALSE(b.image().positionReached);
  const std::int32_t rest = b.image().distanceToGo;
  b.channel.move(rest);
  b.channel.move(-rest);
  b.cycle();
  EXPECT_TRUE(b.image().positionReached);
  EXPECT_EQ(b.image().distanceToGo, rest);
}

// POS-PLANT-09: twice the load overruns the target range
TEST(Monitoring, Load) {
  plant::AxisSettings settings;
  settings.load = 2000;
  io::AxisChannel p = with(&io::AxisMonitors::targetRange);
  p.monitors.approach = true;
  Bench b = bench(p, settings);
  b.command.motion = motion(1000, 1000);
  b.run(4, &Command::plus, 5000);
  b.untilReset(&Image::working);
  const std::int64_t cutOff = b.axis.position();
  b.untilStands();
  EXPECT_EQ(b.axis.position() - cutOff, 200'000'000);
  EXPECT_TRUE(b.image().positionReached);
  EXPECT_EQ(b.image().errors, kTargetRange);
}

// POS-MON-01, POS-MON-16, POS-RUN-37: acknowledged by an edge, all bits at once
TEST(Monitoring, Acknowledgement) {
  Bench b = bench();
  b.command.acknowledge = true;
  b.call();
  b.channel.move(100'000'001);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange);
  b.channel.move(400'000'000);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange | kTravelRange);
  b.call();
  EXPECT_NE(b.image().errors, 0);
  b.command.acknowledge = false;
  b.call();
  b.channel.move(-450'000'000);
  b.cycle();
  // With the edge of ERR_A a start of the same call is accepted.
  b.command.mode = 1;
  b.command.acknowledge = b.command.minus = true;
  EXPECT_EQ(b.call(), kNoError);
  EXPECT_EQ(b.image().errors, 0);
  EXPECT_TRUE(b.image().working);
}

}  // namespace
}  // namespace merker::positioning
