// Reference-point runs: the cases beside the golden ones (technology manual 3.4.4, 3.4.5; POS-REF).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

Bench bench(std::int64_t pulse, bool below, plant::AxisSettings settings = {}) {
  io::AxisChannel p = analogAxis();
  p.reference = 500;
  p.referenceBelowSwitch = below;
  Bench b(p, settings, pulse);
  b.command.motion = motion(5000, 5000);
  return b;
}

// Where the axis takes its coordinate, and that it has it there.
std::int64_t found(Bench& b) {
  b.untilReset(&Image::working);
  EXPECT_TRUE(b.image().synchronous);
  return b.axis.pulse() - b.image().position + 500;
}

// POS-REF-08: two directions, two locations, two beginnings on the switch
TEST(Reference, AllCases) {
  struct Row {
    std::int64_t pulse;
    bool below;
    bool Command::*start;
    std::int64_t mark;
  };
  for (const Row& row : {Row{10'000, false, &Command::plus, 36'000},
                         {10'000, true, &Command::plus, 30'000},
                         {60'000, true, &Command::minus, 30'000},
                         {60'000, false, &Command::minus, 36'000},
                         {33'000, false, &Command::plus, 36'000},
                         {33'000, false, &Command::minus, 36'000},
                         {33'000, true, &Command::plus, 30'000},
                         {33'000, true, &Command::minus, 30'000}}) {
    Bench b = bench(row.pulse, row.below);
    ASSERT_EQ(b.run(3, row.start), kNoError);
    EXPECT_EQ(found(b), row.mark) << row.pulse << row.below;
    EXPECT_FALSE(b.image().positionReached);  // POS-REF-13
    EXPECT_EQ(b.image().distanceToGo, 0);     // POS-REF-16
    EXPECT_EQ(b.image().lastTarget, b.image().position);
  }
}

// POS-REF-09, POS-REF-11: a short switch is passed while the axis slows down
TEST(Reference, ShortSwitch) {
  plant::AxisSettings settings;
  settings.places.reference = {30'300, 30'800};
  Bench back = bench(10'000, true, settings);
  back.run(3, &Command::plus);
  EXPECT_EQ(found(back), 30'000);
  Bench ahead = bench(10'000, false, settings);
  ahead.run(3, &Command::plus);
  EXPECT_EQ(found(ahead), 32'000);
}

// POS-REF-04, POS-REF-18: a run that is stopped or aborted leaves the axis without synchronisation
TEST(Reference, StopAndAbort) {
  for (const bool stops : {true, false}) {
    Bench b = bench(10'000, false);
    b.job(1, 0);
    EXPECT_TRUE(b.image().synchronous);
    b.run(3, &Command::plus);
    EXPECT_FALSE(b.image().synchronous);
    b.cycles(500);
    (stops ? b.command.stop : b.command.driveEnable) = stops;
    b.call();
    b.untilReset(&Image::working);
    b.cycles(1000);
    EXPECT_FALSE(b.image().synchronous);
    EXPECT_EQ(b.axis.speed(), 0);
  }
}

// POS-REF-18: a mark that is passed while it ramps down is no reference point any more
TEST(Reference, StopBeforeTheMark) {
  Bench b = bench(10'000, false);
  b.run(3, &Command::plus);
  b.until([&] { return b.axis.pulse() > 35'980; });
  b.command.stop = true;
  b.call();
  b.untilReset(&Image::working);
  EXPECT_GT(b.axis.pulse(), 36'000);
  EXPECT_FALSE(b.image().synchronous);
}

// POS-REF-10: creep at the switch, off at the mark; rapid only with SPEED = TRUE
TEST(Reference, Digital) {
  for (const bool quickly : {true, false}) {
    for (const bool below : {false, true}) {
      io::AxisChannel p = digitalAxis();
      p.reference = 500;
      p.referenceBelowSwitch = below;
      Bench b(p, contactors(), 20'000);
      b.command.motion = rapid({3000, 100});
      b.command.motion.rapid = quickly;
      b.run(3, &Command::plus);
      std::vector<int> all;
      b.watch = [&] {
        const int now = b.channel.outputs().digital;
        if (all.empty() || all.back() != now) all.push_back(now);
      };
      EXPECT_EQ(b.untilSet(&Image::synchronous), b.number);
      EXPECT_FALSE(b.image().working);
      constexpr int kRapidPlus = 0b0101, kCreepPlus = 0b0110, kCreepMinus = 0b1010;
      std::vector<int> wanted{kCreepPlus};
      if (quickly) wanted.insert(wanted.begin(), kRapidPlus);
      if (below) wanted.insert(wanted.end(), {0, kCreepMinus});
      wanted.push_back(0);
      EXPECT_EQ(all, wanted);
      b.untilStands();
      EXPECT_EQ(b.axis.pulse() - b.image().position + 500, below ? 30'000 : 36'000);
    }
  }
}

// POS-REF-12: the wrong way there are no software limits; the hardware switch stops the axis, and
// the monitoring notices it.
TEST(Reference, WrongDirection) {
  Bench b = bench(10'000, false);
  b.run(3, &Command::minus);
  b.untilError(kMovement);
  EXPECT_LT(b.axis.pulse(), -20'000);
  EXPECT_FALSE(b.image().synchronous);
  EXPECT_FALSE(b.image().working);
}

// POS-REF-15: software limits hold from then on, at coordinates of the reference point
TEST(Reference, LimitsHoldFromThenOn) {
  Bench b = bench(10'000, false);
  b.p.highLimit = 2000;
  b.p.lowLimit = -2000;
  b.channel = Channel(b.p);
  b.run(3, &Command::plus);
  b.untilReset(&Image::working);
  b.command.mode = 1;
  b.command.plus = true;
  b.call();
  b.untilReset(&Image::working);
  b.untilStands();
  EXPECT_NEAR(b.image().position, 2000, 10);
}

// POS-REF-21: a rotary axis passes the switch once in each revolution
TEST(Reference, RotaryAxis) {
  for (const std::int64_t pulse : {500, 4000, 7900}) {
    io::AxisChannel p = analogAxis();
    p.rotary = true;
    p.rotaryEnd = 8000;
    plant::AxisSettings settings;
    settings.places.revolution = 8000;
    settings.places.reference = {2300, 3300};
    settings.places.workpiece = {};
    Bench b(p, settings, pulse);
    b.command.motion = motion(2000, 5000);
    b.run(3, &Command::plus);
    b.untilReset(&Image::working);
    EXPECT_EQ((b.axis.pulse() - b.image().position + 16'000) % 8000, 4000) << pulse;
  }
}

// POS-REF-20, POS-ENC-06: the mark is taken at the same pulse from both sides
TEST(Reference, MarkFromBothSides) {
  io::AxisChannel p = analogAxis();
  for (const int direction : {1, -1}) {
    p.referenceBelowSwitch = direction < 0;
    Bench b(p, {}, 33'000);
    b.command.motion = motion(5000, 5000);
    b.run(3, &Command::plus);
    b.untilReset(&Image::working);
    EXPECT_EQ((b.axis.pulse() - b.image().position) % 2000, 0);
  }
}

// POS-REF-22, POS-ERR-16
TEST(Reference, NotOutsideTheWorkingRange) {
  Bench b = bench(10'000, false);
  b.job(1, 100'000'000);
  b.channel.move(1);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange);
  b.acknowledge();
  EXPECT_EQ(b.run(3, &Command::plus), 0x3008);
  EXPECT_TRUE(b.image().synchronous);
}

}  // namespace
}  // namespace merker::positioning
