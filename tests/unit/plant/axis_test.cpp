// The axis by itself: drives, inertia, limit switches, what lies along it, faults (POS-PLANT).
#include "plant/axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace merker::plant {
namespace {

constexpr std::int64_t kVolt = 1'000'000'000;  // nV

struct Log : AxisObserver {
  void moved(std::int64_t pulses) override { count += pulses; }
  void zeroMark() override { marks.push_back(count); }
  void referenceSwitch(bool on) override { switches.emplace_back(on, count); }
  void lengthInput(bool on) override { lengths.emplace_back(on, count); }
  std::int64_t count = 0;
  std::vector<std::int64_t> marks;
  std::vector<std::pair<bool, std::int64_t>> switches, lengths;
};

struct Rig {
  explicit Rig(const AxisSettings& settings = {}, std::int64_t pulse = 0) : axis(settings, pulse) {
    log.count = pulse;
  }
  void run(const AxisInputs& inputs, int steps) {
    while (steps-- > 0) axis.step(inputs, log);
  }
  int stop() {  // steps until it stands, without enable
    int steps = 0;
    for (; axis.speed() != 0 && steps < 100'000; ++steps) axis.step({}, log);
    return steps;
  }
  Axis axis;
  Log log;
};

AxisInputs volts(std::int64_t nanovolts) { return {.nanovolts = nanovolts, .enable = true}; }

// POS-PLANT-04, POS-PLANT-07: 100 000 pulses/s^2 up, coasting with 5000: 100 pulses from creep
TEST(Axis, AnalogDrive) {
  Rig rig;
  rig.run(volts(kVolt), 2);
  EXPECT_EQ(rig.axis.speed(), 800'000);
  rig.run(volts(kVolt), 1);
  EXPECT_EQ(rig.axis.speed(), 1'000'000);
  const std::int64_t from = rig.axis.position();
  EXPECT_EQ(rig.stop(), 50);
  EXPECT_EQ(rig.axis.position() - from, 100'000'000);
  rig.run(volts(-10 * kVolt), 100);
  EXPECT_EQ(rig.axis.speed(), -10'000'000);
}

// POS-PLANT-01, POS-PLANT-07: the sign is CONV_DIR
TEST(Axis, DirectionSignal) {
  AxisSettings settings;
  settings.section = PowerSection::WithDirection;
  Rig rig(settings);
  AxisInputs inputs = volts(5 * kVolt);
  inputs.direction = true;
  rig.run(inputs, 100);
  EXPECT_EQ(rig.axis.speed(), -5'000'000);
}

// POS-PLANT-08, POS-DIGCTRL-01: each printed combination, and no other one
TEST(Axis, Contactors) {
  struct Row {
    std::uint8_t type, rapidPlus, rapidMinus, creepPlus, creepMinus;
  };
  for (const Row& row :
       {Row{1, 0b0101, 0b1001, 0b0110, 0b1010}, Row{2, 0b0101, 0b1001, 0b0100, 0b1000},
        Row{3, 0b0111, 0b1011, 0b0110, 0b1010}, Row{4, 0b0011, 0b1100, 0b0010, 0b1000}})
    for (std::uint8_t contactors = 0; contactors < 16; ++contactors) {
      Stage wanted = Stage::Off;
      if (contactors == row.rapidPlus) wanted = Stage::RapidPlus;
      if (contactors == row.rapidMinus) wanted = Stage::RapidMinus;
      if (contactors == row.creepPlus) wanted = Stage::CreepPlus;
      if (contactors == row.creepMinus) wanted = Stage::CreepMinus;
      EXPECT_EQ(stageOf(row.type, contactors), wanted) << int{row.type} << " " << int{contactors};
    }
  AxisSettings settings;
  settings.section = PowerSection::Contactors;
  Rig rig(settings);
  rig.run({.contactors = 0b0101}, 125);
  EXPECT_EQ(rig.axis.position(), 2'500'000'000);
  EXPECT_EQ(rig.axis.speed(), 10'000'000);
}

// POS-PLANT-09
TEST(Axis, Load) {
  AxisSettings settings;
  settings.load = 2000;
  Rig rig(settings);
  rig.run(volts(kVolt), 10);
  const std::int64_t from = rig.axis.position();
  EXPECT_EQ(rig.stop(), 100);
  EXPECT_EQ(rig.axis.position() - from, 200'000'000);
}

// POS-PLANT-05: 63 % of a step within 20 ms, plus or minus a cycle
TEST(Axis, Lag) {
  AxisSettings settings;
  settings.lag = 11'880;
  settings.acceleration = 100'000'000;
  Rig rig(settings);
  rig.run(volts(10 * kVolt), 5);
  EXPECT_NEAR(static_cast<double>(rig.axis.speed()), 6'321'000, 5000);
}

// POS-PLANT-05: a motor on contactors, too; without them it coasts as ever
TEST(Axis, LagOnContactors) {
  AxisSettings settings;
  settings.section = PowerSection::Contactors;
  settings.lag = 11'880;
  settings.contactorAcceleration = 100'000'000;
  Rig rig(settings);
  rig.run({.contactors = 0b0101}, 5);
  EXPECT_NEAR(static_cast<double>(rig.axis.speed()), 6'321'000, 5000);
  const std::int64_t before = rig.axis.speed();
  rig.run({}, 1);
  EXPECT_EQ(rig.axis.speed(), before - 20'000);
}

// POS-PLANT-06: from 0.5 V on; once it moves it follows down to 0
TEST(Axis, Stiction) {
  AxisSettings settings;
  settings.stiction = kVolt / 2;
  Rig rig(settings);
  rig.run(volts(kVolt / 2 - 1), 10);
  EXPECT_EQ(rig.axis.speed(), 0);
  rig.run(volts(kVolt / 2), 10);
  EXPECT_EQ(rig.axis.speed(), 500'000);
  rig.run(volts(kVolt / 10), 10);
  EXPECT_EQ(rig.axis.speed(), 100'000);
}

// POS-PLANT-13, POS-OVW-22, POS-WIRE-13: off the switch only the other way
TEST(Axis, LimitSwitches) {
  AxisSettings settings;
  settings.lowSwitch = -1000;
  settings.highSwitch = 1000;
  Rig rig(settings);
  rig.run(volts(kVolt), 1000);
  EXPECT_EQ(rig.axis.speed(), 0);
  const std::int64_t overrun = rig.axis.pulse();
  EXPECT_NEAR(static_cast<double>(overrun), 1100, 5);
  rig.run(volts(kVolt), 10);
  EXPECT_EQ(rig.axis.pulse(), overrun);
  rig.run(volts(-kVolt), 100);
  EXPECT_LT(rig.axis.pulse(), 1000);
  rig.run(volts(-kVolt), 1000);
  EXPECT_NEAR(static_cast<double>(rig.axis.pulse()), -1100, 5);
}

// POS-PLANT-10, POS-PLANT-11, POS-PLANT-13, POS-ENC-06: the same pulses there and back, however
// fast
TEST(Axis, PlacesThereAndBack) {
  for (const std::int64_t fastest : {1000, 10'000, 200'000}) {
    AxisSettings settings;
    settings.fastest = fastest;
    settings.acceleration = 10'000'000;
    settings.coast = 10'000'000;
    Rig rig(settings, -500);
    while (rig.axis.pulse() < 36'500) rig.run(volts(10 * kVolt), 1);
    while (rig.axis.pulse() > -500) rig.run(volts(-10 * kVolt), 1);
    rig.stop();
    std::vector<std::int64_t> marks;
    for (std::int64_t mark = 0; mark <= 36'000; mark += 2000) marks.push_back(mark);
    for (std::int64_t mark = 36'000; mark >= 0; mark -= 2000) marks.push_back(mark);
    std::erase_if(rig.log.marks, [](std::int64_t mark) { return mark > 36'000 || mark < 0; });
    EXPECT_EQ(rig.log.marks, marks) << fastest;
    using Edges = std::vector<std::pair<bool, std::int64_t>>;
    EXPECT_EQ(rig.log.switches,
              (Edges{{true, 30'300}, {false, 35'300}, {true, 35'299}, {false, 30'299}}));
    EXPECT_EQ(rig.log.lengths, (Edges{{true, 1000}, {false, 1250}, {true, 1249}, {false, 999}}));
  }
}

// POS-PLANT-22: the encoder is at the motor; the switches see the load, behind the play on the way
// back
TEST(Axis, BacklashThereAndBack) {
  for (const std::int64_t fastest : {1000, 10'000, 200'000}) {
    AxisSettings settings;
    settings.fastest = fastest;
    settings.acceleration = settings.coast = 10'000'000;
    settings.places.backlash = 100;
    Rig rig(settings, -500);
    while (rig.axis.pulse() < 36'500) rig.run(volts(10 * kVolt), 1);
    EXPECT_EQ(rig.axis.load(), rig.axis.pulse());
    while (rig.axis.pulse() > -700) rig.run(volts(-10 * kVolt), 1);
    EXPECT_EQ(rig.axis.load(), rig.axis.pulse() + 100);
    using Edges = std::vector<std::pair<bool, std::int64_t>>;
    EXPECT_EQ(rig.log.switches,
              (Edges{{true, 30'300}, {false, 35'300}, {true, 35'199}, {false, 30'199}}));
    EXPECT_EQ(rig.log.lengths, (Edges{{true, 1000}, {false, 1250}, {true, 1149}, {false, 899}}));
    EXPECT_EQ(std::count(rig.log.marks.begin(), rig.log.marks.end(), 2000), 2);
  }
}

// POS-PLANT-22: within the play only the motor moves, and the limit switch follows the load.
TEST(Axis, BacklashAtALimitSwitch) {
  AxisSettings settings;
  settings.highSwitch = 1000;
  settings.places.backlash = 150;
  Rig rig(settings);
  rig.run(volts(kVolt), 1000);
  const std::int64_t overrun = rig.axis.pulse();
  ASSERT_EQ(rig.axis.load(), overrun);
  while (rig.axis.pulse() > overrun - 150) rig.run(volts(-kVolt / 10), 1);
  EXPECT_NEAR(static_cast<double>(rig.axis.load()), static_cast<double>(overrun), 5);
  while (rig.axis.pulse() > 920) rig.run(volts(-kVolt / 10), 1);
  rig.stop();
  const std::int64_t load = rig.axis.load();
  ASSERT_GT(load, 1000);
  ASSERT_LT(rig.axis.pulse(), 1000);
  rig.run(volts(kVolt), 10);
  EXPECT_EQ(rig.axis.speed(), 0) << "the motor is below the switch, the load is not";
  EXPECT_EQ(rig.axis.load(), load);
}

// POS-PLANT-15: each revolution of a rotary axis
TEST(Axis, RotaryPlaces) {
  AxisSettings settings;
  settings.places.revolution = 8000;
  settings.places.reference = {2300, 3300};
  settings.places.workpiece = {};
  Rig rig(settings);
  while (rig.axis.pulse() < 20'000) rig.run(volts(10 * kVolt), 1);
  ASSERT_EQ(rig.log.switches.size(), 6u);
  EXPECT_EQ(rig.log.switches[4].second, 18'300);
  EXPECT_EQ(rig.log.switches[5].second, 19'300);
}

// The mark of a turn within one step is passed twice.
TEST(Axis, TurnsWithinAStep) {
  AxisSettings settings;
  settings.acceleration = 1'000'000;
  Rig rig(settings, -5);
  rig.run(volts(2 * kVolt), 1);
  const std::int64_t before = rig.axis.pulse();
  rig.run(volts(-2 * kVolt), 1);
  EXPECT_EQ(rig.axis.pulse(), before);
  EXPECT_EQ(rig.axis.pulse(), -1);
  EXPECT_EQ(rig.log.count, rig.axis.pulse());
  EXPECT_EQ(rig.log.marks, (std::vector<std::int64_t>{0, 0}));
}

// POS-PLANT-16, POS-PLANT-17
TEST(Axis, DriftHandAndFaults) {
  AxisSettings settings;
  settings.drift = 10;
  Rig drifting(settings);
  drifting.run({}, 250);
  EXPECT_NEAR(static_cast<double>(drifting.axis.pulse()), 10, 1);
  Rig hand;
  hand.axis.turn(-100);
  hand.run({}, 250);
  EXPECT_NEAR(static_cast<double>(hand.axis.pulse()), -100, 2);
  Rig emergency;
  emergency.run(volts(kVolt), 10);
  emergency.axis.faults.emergencyStop = true;
  emergency.run(volts(kVolt), 50);
  EXPECT_EQ(emergency.axis.speed(), 0);
  Rig lost;
  lost.axis.faults.lost = 7;
  lost.run(volts(kVolt), 250);
  EXPECT_EQ(lost.log.count, lost.axis.pulse() - 7);
  Rig stuck(AxisSettings{}, 30'000);
  stuck.axis.faults.switchStuck = true;
  stuck.run(volts(kVolt), 250);
  EXPECT_GT(stuck.axis.pulse(), 30'300);
  EXPECT_TRUE(stuck.log.switches.empty());
}

// POS-REF-19, POS-MON-04: a mark that is too short at this speed is missed
TEST(Axis, FastMarks) {
  AxisSettings settings;
  settings.fastest = 200'000;
  settings.fastestMark = 120'000;
  settings.acceleration = 10'000'000;
  settings.highSwitch = 100'000'000;
  Rig rig(settings, 1);
  rig.run(volts(10 * kVolt), 100);
  EXPECT_TRUE(rig.log.marks.empty());
  rig.run(volts(5 * kVolt), 100);
  EXPECT_FALSE(rig.log.marks.empty());
}

}  // namespace
}  // namespace merker::plant
