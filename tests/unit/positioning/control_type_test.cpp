// The four control types of the digital outputs, as the manual prints them in 4.2.4 (POS-DIGCTRL).
#include <gtest/gtest.h>

#include "bench.h"
#include "positioning/digital_drive.h"

namespace merker::positioning {
namespace {

// "1010": Q0 to Q3
std::string text(std::uint8_t digital) {
  std::string result;
  for (unsigned i = 0; i < 4; ++i) result += (digital >> i & 1) != 0 ? '1' : '0';
  return result;
}

// All combinations of a run, each once, in their order.
std::string sequence(std::uint8_t type, bool Command::*direction, bool rapidly = true) {
  Bench b(digitalAxis(type), contactors(type));
  b.command.motion = rapid({3000, 100});
  b.command.motion.rapid = rapidly;
  b.run(4, direction, 20'000);
  std::string all, last;
  b.watch = [&] {
    const std::string now = text(b.channel.outputs().digital);
    if (now != last) all += (all.empty() ? "" : " ") + now;
    last = now;
  };
  b.until([&] { return b.image().positionReached && b.axis.speed() == 0; });
  EXPECT_EQ(b.axis.pulse() / 1000, direction == &Command::plus ? 20 : -20);
  return all;
}

// POS-DIGCTRL-02, POS-DIGCTRL-03, POS-DIGCTRL-04, POS-DIGCTRL-05, POS-DIGCTRL-07, POS-DIGCTRL-09,
// POS-DIGCTRL-06, POS-DIGCTRL-10, POS-DIGCTRL-11, POS-DIGCTRL-12, POS-PARAM-11
TEST(ControlTypes, SequenceOfARun) {
  EXPECT_EQ(sequence(1, &Command::plus), "1010 0110 0000");
  EXPECT_EQ(sequence(1, &Command::minus), "1001 0101 0000");
  EXPECT_EQ(sequence(2, &Command::plus), "1010 0010 0000 0100");
  EXPECT_EQ(sequence(2, &Command::minus), "1001 0001 0000 0100");
  EXPECT_EQ(sequence(3, &Command::plus), "1110 0110 0000");
  EXPECT_EQ(sequence(3, &Command::minus), "1101 0101 0000");
  EXPECT_EQ(sequence(4, &Command::plus), "1100 0100 0000");
  EXPECT_EQ(sequence(4, &Command::minus), "0011 0001 0000");
}

// POS-DIGCTRL-13, POS-RUN-22
TEST(ControlTypes, CreepFromTheStart) {
  EXPECT_EQ(sequence(1, &Command::plus, false), "0110 0000");
  EXPECT_EQ(sequence(2, &Command::minus, false), "0001 0000 0100");
  EXPECT_EQ(sequence(3, &Command::plus, false), "0110 0000");
  EXPECT_EQ(sequence(4, &Command::minus, false), "0001 0000");
}

// POS-RUN-21, POS-END-04: creep in the changeover point, off behind the whole way of creep
TEST(ControlTypes, SwitchesInThePoint) {
  DigitalDrive drive(digitalAxis());
  drive.start(1, rapid({3000, 100}));
  drive.travel({1, 2901});
  EXPECT_EQ(text(drive.outputs(false).digital), "1010");
  drive.travel({0, 2900});
  EXPECT_EQ(text(drive.outputs(false).digital), "0110");
  EXPECT_FALSE(drive.rampDown(2899));
  EXPECT_TRUE(drive.rampDown(2900));
}

// POS-RUN-22: the changeover point is shown all the same.
TEST(ControlTypes, ChangeoverOfARunInCreep) {
  Bench b(digitalAxis(), contactors());
  b.command.motion.differences = {{3000, 100}, {3000, 100}};
  b.run(4, &Command::plus, 20'000);
  b.untilSet(&Image::changedOver);
  EXPECT_EQ(b.image().position / 10, 1700);
}

// POS-DIGCTRL-10: the cycles of D1
TEST(ControlTypes, PositionReached) {
  Bench b(digitalAxis(2), contactors(2));
  b.command.motion = rapid({3000, 100});
  b.run(4, &Command::plus, 20'000);
  EXPECT_EQ(b.until([&] { return (b.channel.outputs().digital & 2) != 0; }), 727);
}

// POS-DIGCTRL-08: drift out of the target range does not reset it, nor does an abort; a start does,
// and so does the start of the CPU.
TEST(ControlTypes, PositionReachedStays) {
  plant::AxisSettings drifting = contactors(2);
  drifting.drift = 10;
  Bench b(digitalAxis(2), drifting);
  b.command.motion = rapid({3000, 100});
  b.run(4, &Command::plus, 20'000);
  b.until([&] { return b.axis.pulse() > 20'100; });
  EXPECT_EQ(b.channel.outputs().digital, 2);
  b.command.driveEnable = false;
  b.call();
  b.cycle();
  EXPECT_EQ(b.channel.outputs().digital, 2);
  b.command.driveEnable = true;
  b.run(4, &Command::plus, 20'000);
  b.cycle();
  EXPECT_EQ(b.channel.outputs().digital, 0b0101);
  b.untilSet(&Image::positionReached);
  b.channel.start();
  EXPECT_EQ(b.channel.outputs().digital, 0);
}

// POS-DIGCTRL-14
TEST(ControlTypes, Abort) {
  for (std::uint8_t type = 1; type <= 4; ++type) {
    Bench b(digitalAxis(type), contactors(type));
    b.command.motion = rapid({3000, 100});
    b.run(4, &Command::plus, 20'000);
    b.cycles(100);
    EXPECT_NE(b.channel.outputs().digital, 0);
    b.command.driveEnable = false;
    b.call();
    b.cycle();
    EXPECT_EQ(b.channel.outputs().digital, 0);
    b.untilStands();
    EXPECT_EQ(b.channel.outputs().digital, 0);
  }
}

// POS-JOG-05, POS-JOG-06, POS-DIGCTRL-15, POS-OPEN-23: a cycle with all outputs off between the
// directions, and never both of them.
TEST(ControlTypes, ChangeOfDirection) {
  constexpr std::uint8_t kPlus[] = {0b0100, 0b0100, 0b0100, 0b0011};
  constexpr std::uint8_t kMinus[] = {0b1000, 0b1000, 0b1000, 0b1100};
  for (std::uint8_t type = 1; type <= 4; ++type) {
    Bench b(digitalAxis(type), contactors(type));
    b.command.motion = rapid({3000, 100});
    b.run(1, &Command::plus);  // released at once: the levels count
    b.command.plus = true;
    b.call();
    int off = 0;
    b.watch = [&] {
      const std::uint8_t digital = b.channel.outputs().digital;
      EXPECT_FALSE((digital & kPlus[type - 1]) != 0 && (digital & kMinus[type - 1]) != 0);
      off += digital == 0 ? 1 : 0;
    };
    b.cycles(200);
    EXPECT_EQ(off, 0);
    b.command.plus = false;
    b.command.minus = true;
    b.call();
    b.until([&] { return (b.channel.outputs().digital & kMinus[type - 1]) != 0; });
    EXPECT_EQ(off, 1);
    EXPECT_TRUE(b.image().working);
  }
}

}  // namespace
}  // namespace merker::positioning
