// Start requests: every number of STATUS, the order of the checks, what a start sets (POS-ERR,
// POS-RUN-24 to -28, POS-RUN-33 to -36).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

constexpr std::int32_t kFar8 = 500'000'000;

io::AxisChannel rotary(std::int32_t end) {
  io::AxisChannel p = analogAxis();
  p.rotary = true;
  p.rotaryEnd = end;
  return p;
}

// A bench whose axis is synchronised at a position, with runs that are quick.
Bench at(std::int32_t position, io::AxisChannel p = analogAxis()) {
  Bench b(p);
  b.command.motion = quick();
  EXPECT_EQ(b.job(1, position), kNoError);
  return b;
}

// POS-ERR-06, POS-ERR-07, POS-ERR-08, POS-IF44-02, POS-IF46-02: until the cause is gone
// (POS-ERR-03)
TEST(StartErrors, WrongBlockOrChannel) {
  Bench digital(digitalAxis(), contactors());
  digital.block = Block(io::AxisOutput::Analog);
  EXPECT_EQ(digital.run(4, &Command::plus, 1000), 0x2001);
  EXPECT_FALSE(digital.channel.working());
  Bench b(analogAxis());
  b.block = Block(io::AxisOutput::Digital);
  EXPECT_EQ(b.call(), 0x2002);
  b.block = Block(io::AxisOutput::Analog);
  b.command.channel = 1;
  EXPECT_EQ(b.call(), 0x2004);
  EXPECT_TRUE(b.block.answer().error);
  b.command.channel = 0;
  EXPECT_EQ(b.call(), kNoError);
  EXPECT_FALSE(b.block.answer().error);
}

// POS-OVW-12, POS-ERR-11, POS-ERR-12, POS-ERR-13, POS-ERR-14, POS-INCA-14, POS-INCA-02
TEST(StartErrors, ModeAndStartBits) {
  Bench b = at(0);
  EXPECT_EQ(b.run(2, &Command::start), 0x3003);
  EXPECT_EQ(b.run(0, &Command::plus), 0x3003);
  EXPECT_EQ(b.run(257, &Command::plus), 0x3003);
  b.command.mode = 0;
  b.command.channel = 1;  // clears nothing but the status
  b.call();
  b.command.channel = 0;
  EXPECT_EQ(b.call(), kNoError);  // without a start request mode 0 is no error
  for (const int mode : {1, 3, 4}) EXPECT_EQ(b.run(mode, &Command::start, 1000), 0x3005) << mode;
  for (auto bit : {&Command::plus, &Command::start}) {
    b.command.mode = bit == &Command::start ? 5 : 4;
    b.command.minus = true;
    EXPECT_EQ(b.press(bit), 0x3004);
    b.command.minus = false;
    b.call();
  }
  EXPECT_EQ(b.run(5, &Command::plus, 1000), 0x3006);
  EXPECT_FALSE(b.image().working);
  EXPECT_EQ(b.image().lastTarget, 0);
}

// POS-ERR-15, POS-INCA-01
TEST(StartErrors, NotSynchronised) {
  Bench b(analogAxis());
  EXPECT_EQ(b.run(5, &Command::start, 1000), 0x3007);
}

// POS-ERR-17, POS-ERR-18, POS-ERR-19, POS-ERR-20, POS-ERR-21, POS-PARAM-29
TEST(StartErrors, NoStartEnable) {
  io::AxisChannel faulty = analogAxis();
  faulty.lowLimit = 10;
  faulty.highLimit = 5;
  Bench unsound(faulty);
  EXPECT_FALSE(unsound.image().parametrised);
  EXPECT_EQ(unsound.run(4, &Command::plus, 1000), 0x3101);
  EXPECT_EQ(unsound.job(2), 0x4001);  // POS-ERR-43

  Bench b = at(0);
  b.command.driveEnable = false;
  EXPECT_EQ(b.run(4, &Command::plus, 1000), 0x3102);
  b.command.driveEnable = true;
  b.command.stop = true;
  EXPECT_EQ(b.run(4, &Command::plus, 1000), 0x3103);
  b.command.stop = false;
  ASSERT_EQ(b.run(4, &Command::plus, 100'000), kNoError);
  EXPECT_EQ(b.press(&Command::plus), 0x3104);
  EXPECT_TRUE(b.image().working);
}

// POS-RUN-28: each of the five conditions by itself
TEST(StartErrors, StartEnable) {
  Bench b = at(0);
  EXPECT_TRUE(b.image().startEnabled);
  b.command.stop = true;
  b.call();
  EXPECT_FALSE(b.image().startEnabled);
  b.command.stop = false;
  b.command.driveEnable = false;
  b.call();
  EXPECT_FALSE(b.image().startEnabled);
  b.command.driveEnable = true;
  b.run(4, &Command::plus, 5000);
  EXPECT_FALSE(b.image().startEnabled);
  b.untilReset(&Image::working);
  EXPECT_TRUE(b.image().startEnabled);
}

// POS-ERR-23, POS-ERR-24, POS-ERR-25, POS-ERR-26, POS-REF-17, POS-IF44-11, POS-IF44-22,
// POS-IF44-23, POS-JOG-09
TEST(StartErrors, Speeds) {
  struct Row {
    std::int32_t speed, accel, decel;
    int mode;
    std::uint16_t status;
  };
  for (const Row& row : {Row{999, 100, 100, 4, 0x3202},
                         {10'001, 100, 100, 4, 0x3202},
                         {1000, 0, 100, 4, 0x3203},
                         {1000, 100'001, 100, 4, 0x3203},
                         {1000, 100, 0, 4, 0x3204},
                         {1000, 100, 100'001, 4, 0x3204},
                         {999, 100, 100, 3, 0x3206},
                         {10'001, 100, 100, 3, 0x3202},
                         {5, 100, 100, 1, 0x3202},
                         {10'000, 100'000, 100'000, 4, 0}}) {
    Bench b = at(0);
    b.command.motion.speed = row.speed;
    b.command.motion.acceleration = row.accel;
    b.command.motion.deceleration = row.decel;
    EXPECT_EQ(b.run(row.mode, &Command::plus, 5000), row.status) << row.speed << row.mode;
    EXPECT_EQ(b.image().working, row.status == 0);
  }
}

// POS-RUN-24, POS-RUN-25, POS-ERR-27, POS-ERR-28, POS-ERR-29, POS-ERR-30
TEST(StartErrors, Differences) {
  struct Row {
    Differences differences;
    std::uint16_t analog, digital;
  };
  for (const Row& row : {Row{{100'000'001, 100}, 0x3301, 0x3301},
                         {{1000, -1}, 0x3301, 0x3301},
                         {{99, 100}, 0, 0x3303},
                         {{1000, 24}, 0x3304, 0x3304},
                         {{1000, 0}, 0x3304, 0x3304},
                         {{0, 100}, 0x3305, 0x3303},
                         {{24, 100}, 0x3305, 0x3303},
                         {{25, 25}, 0, 0}}) {
    Bench analog = at(0);
    analog.command.motion = motion(1000, 100, row.differences);
    EXPECT_EQ(analog.run(4, &Command::plus, 5000), row.analog) << row.differences.changeover;
    Bench digital = at(0, digitalAxis());
    digital.command.motion = rapid(row.differences);
    EXPECT_EQ(digital.run(4, &Command::plus, 5000), row.digital) << row.differences.changeover;
  }
}

// POS-ERR-31, POS-ERR-33, POS-ERR-34, POS-ERR-35, POS-ERR-36, POS-INCA-09, POS-INCR-15,
// POS-OPEN-08, POS-OPEN-19
TEST(StartErrors, Targets) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -100'000;
  p.highLimit = 100'000;
  EXPECT_EQ(at(0, p).run(5, &Command::start, 100'001), 0x3401);
  EXPECT_EQ(at(0, p).run(5, &Command::start, -100'001), 0x3401);
  EXPECT_EQ(at(0, p).run(5, &Command::start, 99'976), 0x3406);
  EXPECT_EQ(at(0, p).run(5, &Command::start, 99'975), kNoError);
  EXPECT_EQ(at(0, p).run(4, &Command::minus, 99'976), 0x3406);
  EXPECT_EQ(at(0, p).run(4, &Command::plus, -1), 0x3403);
  p.monitors.workingRange = false;
  EXPECT_EQ(at(0, p).run(4, &Command::plus, 200'000), kNoError);
  EXPECT_EQ(at(0, p).run(5, &Command::start, 100'001), 0x3401);
  EXPECT_EQ(at(0, p).run(4, &Command::minus, kFar8), 0x3404);
  EXPECT_EQ(at(0, p).run(4, &Command::plus, kFar8), 0x3405);
  EXPECT_EQ(at(0, p).run(4, &Command::plus, kFar8 - 1), kNoError);
}

// POS-ERR-01, POS-ERR-32, POS-OPEN-07
TEST(StartErrors, TargetsOfARotaryAxis) {
  EXPECT_EQ(at(500, rotary(1000)).run(5, &Command::start, -1), 0x3402);
  EXPECT_EQ(at(500, rotary(1000)).run(5, &Command::start, 1000), 0x3402);
  EXPECT_EQ(at(500, rotary(1000)).run(5, &Command::plus, 0), kNoError);
}

// POS-ERR-37, POS-ERR-38: the axis was moved 20 pulses from its last target.
TEST(StartErrors, WayTooLong) {
  for (const int direction : {-1, 1}) {
    Bench b(analogAxis());
    b.command.motion = quick();
    b.channel.move(-20 * direction);
    b.cycle();
    EXPECT_EQ(b.image().distanceToGo, 20 * direction);
    EXPECT_EQ(b.run(4, direction > 0 ? &Command::plus : &Command::minus, 499'999'990),
              direction > 0 ? 0x3502 : 0x3501);
  }
}

// POS-RUN-26, POS-ERR-39, POS-ERR-40, POS-INCR-04, POS-INCR-05, POS-OPEN-06, POS-OPEN-17
TEST(StartErrors, WayTooShort) {
  for (auto bit : {&Command::plus, &Command::minus}) {
    const bool plus = bit == &Command::plus;
    Bench none = at(0);
    EXPECT_EQ(none.run(4, bit, 25), kNoError);
    EXPECT_FALSE(none.image().working);
    EXPECT_TRUE(none.image().positionReached);
    EXPECT_EQ(none.image().lastTarget, plus ? 25 : -25);
    EXPECT_EQ(at(0).run(4, bit, 26), plus ? 0x3503 : 0x3504);
    EXPECT_EQ(at(0).run(4, bit, 99), plus ? 0x3503 : 0x3504);
    EXPECT_EQ(at(0).run(4, bit, 100), kNoError);
  }
  EXPECT_EQ(at(0).run(5, &Command::start, 60), 0x3503);  // POS-INCA-08
}

// POS-RUN-36: of two errors the earlier one
TEST(StartErrors, Order) {
  Bench b(analogAxis());
  b.command.driveEnable = false;
  b.command.stop = true;
  b.command.motion.speed = 1;
  EXPECT_EQ(b.run(2, &Command::start), 0x3003);
  EXPECT_EQ(b.run(5, &Command::plus), 0x3006);
  EXPECT_EQ(b.run(5, &Command::start), 0x3102);
  b.command.driveEnable = true;
  EXPECT_EQ(b.run(5, &Command::start), 0x3103);
  b.command.stop = false;
  EXPECT_EQ(b.run(5, &Command::start), 0x3007);
  EXPECT_EQ(b.run(4, &Command::plus, -1), 0x3202);
  b.command.motion = quick();
  EXPECT_EQ(b.run(4, &Command::plus, -1), 0x3403);
}

// POS-ERR-03, POS-OPEN-12: held until the next request
TEST(StartErrors, AreHeldUntilTheNextStart) {
  Bench b = at(0);
  b.run(4, &Command::plus, -1);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(b.call(), 0x3403);
  EXPECT_TRUE(b.block.answer().error);
  EXPECT_EQ(b.run(4, &Command::plus, 1000), kNoError);
  EXPECT_FALSE(b.block.answer().error);
}

// POS-RUN-35, POS-ERR-10, POS-RUN-34
TEST(StartErrors, ChangeOfModeDuringARun) {
  Bench b = at(0);
  b.run(4, &Command::plus, 100'000);
  b.cycles(10);
  b.command.mode = 1;
  EXPECT_EQ(b.call(), 0x3002);
  EXPECT_TRUE(b.image().working);
  EXPECT_EQ(static_cast<int>(b.image().mode), 4);
  EXPECT_EQ(b.press(&Command::plus), 0x3002);
  b.untilReset(&Image::working);
  b.call();
  EXPECT_EQ(static_cast<int>(b.image().mode), 1);
  EXPECT_EQ(b.image().lastTarget, 100'000);
}

// POS-ERR-05: whatever comes in, only listed numbers come out.
TEST(StartErrors, OnlyListedNumbers) {
  constexpr std::uint16_t kListed[] = {
      0,      0x2001, 0x2002, 0x2004, 0x3001, 0x3002, 0x3003, 0x3004, 0x3005, 0x3006,
      0x3007, 0x3008, 0x3101, 0x3102, 0x3103, 0x3104, 0x3105, 0x3202, 0x3203, 0x3204,
      0x3206, 0x3301, 0x3303, 0x3304, 0x3305, 0x3401, 0x3402, 0x3403, 0x3404, 0x3405,
      0x3406, 0x3501, 0x3502, 0x3503, 0x3504, 0x3505, 0x3506, 0x4001, 0x4002, 0x4004,
      0x4101, 0x4102, 0x4103, 0x4104, 0x4105, 0x4106};
  std::uint64_t state = 1;
  const auto random = [&](std::int64_t from, std::int64_t to) {
    state = state * 6'364'136'223'846'793'005u + 1'442'695'040'888'963'407u;
    return static_cast<std::int32_t>(
        from +
        static_cast<std::int64_t>((state >> 33) % static_cast<std::uint64_t>(to - from + 1)));
  };
  const auto listed = [&](std::uint16_t number) {
    return std::find(std::begin(kListed), std::end(kListed), number) != std::end(kListed);
  };
  for (const bool round : {false, true}) {
    Bench b(round ? rotary(10'000) : analogAxis());
    for (int i = 0; i < 20'000; ++i) {
      Command& c = b.command;
      c.mode = random(-1, 6);
      for (auto bit : {&Command::start, &Command::plus, &Command::minus})
        c.*bit = random(0, 2) == 0;
      for (auto bit : {&Command::stop, &Command::jobRequest}) c.*bit = random(0, 9) == 0;
      c.acknowledge = random(0, 1) == 0;
      c.driveEnable = random(0, 20) != 0;
      c.target = random(0, 9) == 0 ? random(INT32_MIN, INT32_MAX) : random(-100, 20'000);
      c.job = random(0, 3);
      c.jobValue = random(0, 3) == 0 ? random(INT32_MIN, INT32_MAX) : random(-100, 9999);
      c.motion = quick();
      if (random(0, 9) == 0) c.motion.speed = random(-1, 20'000);
      if (random(0, 9) == 0) c.motion.differences.plus.cutOff = random(-1, 2000);
      b.call();
      ASSERT_TRUE(listed(b.block.answer().status)) << std::hex << b.block.answer().status;
      ASSERT_TRUE(listed(b.block.answer().jobStatus)) << std::hex << b.block.answer().jobStatus;
      b.cycles(random(0, 20));
    }
  }
}

}  // namespace
}  // namespace merker::positioning
