// Jobs and length measurement (technology manual 3.4.8 to 3.4.10; POS-JOB, POS-ERR-43 to -51).
#include <gtest/gtest.h>

#include "bench.h"

namespace merker::positioning {
namespace {

io::AxisChannel small() {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -400;
  p.highLimit = 400;
  return p;
}

// POS-JOB-01, POS-JOB-03, POS-JOB-04, POS-JOB-05
TEST(Jobs, Handshake) {
  Bench b(small());
  EXPECT_TRUE(b.block.answer().jobDone);
  b.command.job = 3;
  b.command.jobRequest = true;
  b.call();
  EXPECT_FALSE(b.block.answer().jobDone);
  EXPECT_TRUE(b.block.answer().jobError);
  EXPECT_EQ(b.block.answer().jobStatus, 0x4004);
  b.command.job = 1;
  b.command.jobValue = 200;
  b.call();  // no edge
  EXPECT_TRUE(b.block.answer().jobDone);
  EXPECT_TRUE(b.block.answer().jobError);
  EXPECT_EQ(b.image().position, 0);
  b.command.jobRequest = false;
  b.call();
  EXPECT_EQ(b.job(1, 200), kNoError);
  EXPECT_FALSE(b.block.answer().jobError);
  EXPECT_EQ(b.image().position, 200);
}

// POS-JOB-06, POS-JOB-18, POS-ERR-45, POS-ERR-46, POS-ERR-51, POS-OPEN-19
TEST(Jobs, Coordinates) {
  io::AxisChannel p = small();
  p.monitors.workingRange = false;
  Bench b(p);
  for (const std::int32_t id : {0, 3, -1}) EXPECT_EQ(b.job(id), 0x4004);
  EXPECT_EQ(b.job(1, 401), 0x4101);
  EXPECT_EQ(b.job(1, -401), 0x4101);
  EXPECT_FALSE(b.image().synchronous);
  EXPECT_EQ(b.job(1, 400), kNoError);
  EXPECT_EQ(b.job(1, -400), kNoError);
  p.rotary = true;
  p.rotaryEnd = 1000;
  Bench round(p);
  EXPECT_EQ(round.job(1, -1), 0x4106);
  EXPECT_EQ(round.job(1, 1000), 0x4106);
  EXPECT_EQ(round.job(1, 999), kNoError);
  EXPECT_EQ(round.image().position, 999);
}

// POS-JOB-02: DRV_EN, STOP and external errors do not matter
TEST(Jobs, WithoutEnable) {
  Bench b(small());
  b.command.driveEnable = false;
  b.command.stop = true;
  EXPECT_EQ(b.job(1, 5), kNoError);
}

// POS-JOB-07, POS-JOB-08, POS-JOB-10, POS-RUN-33, POS-PARAM-20
TEST(Jobs, SetReferencePoint) {
  io::AxisChannel p = small();
  p.reference = 100;
  Bench b(p);
  EXPECT_EQ(b.image().position, 100);
  b.command.job = 1;
  b.command.jobValue = 300;
  b.command.jobRequest = true;
  b.call();
  EXPECT_EQ(b.image().position, 300);
  EXPECT_TRUE(b.image().synchronous);
  b.channel.move(100);
  b.cycle();
  EXPECT_EQ(b.image().errors, 0);
  b.channel.move(1);
  b.cycle();
  EXPECT_EQ(b.image().errors, kWorkingRange);
  b.channel.start();
  EXPECT_EQ(b.image().position, 100);
  EXPECT_EQ(b.image().lastTarget, 100);
  EXPECT_FALSE(b.image().synchronous);
  EXPECT_EQ(b.image().errors, 0);
}

// POS-JOB-09, POS-JOB-11: an interrupted run ends at the same place
TEST(Jobs, ReferencePointOfAnInterruptedRun) {
  Bench b(analogAxis());
  b.command.motion = quick();
  b.run(4, &Command::plus, 20'000);
  b.until([&] { return b.image().position > 10'000; });
  b.command.stop = true;
  b.call();
  b.untilReset(&Image::working);
  b.command.stop = false;
  const std::int32_t rest = b.image().distanceToGo;
  EXPECT_EQ(b.job(1, 500), kNoError);
  EXPECT_EQ(b.image().distanceToGo, rest);
  b.run(4, &Command::plus, 1);
  b.untilReset(&Image::working);
  b.untilStands();
  EXPECT_NEAR(static_cast<double>(b.axis.pulse()), 20'000, 25);
}

// POS-ERR-47, POS-ERR-48, POS-ERR-49, POS-ERR-50
TEST(Jobs, CoordinatesWithADistanceToGo) {
  io::AxisChannel p = analogAxis();
  p.lowLimit = -500'000'000;
  p.highLimit = 500'000'000;
  for (const int direction : {1, -1}) {
    Bench b(p);
    b.command.motion = motion(10'000, 100'000);
    b.run(4, direction > 0 ? &Command::plus : &Command::minus, 3000);
    b.until([&] { return std::abs(b.image().position) >= 1000; });
    b.command.stop = true;
    b.call();
    b.untilReset(&Image::working);
    const std::int32_t behind = b.image().position, ahead = b.image().distanceToGo;
    const std::int32_t limit = direction * 500'000'000;
    EXPECT_EQ(b.job(1, limit - ahead), kNoError);
    EXPECT_EQ(b.job(1, limit - ahead + direction), direction > 0 ? 0x4103 : 0x4102);
    EXPECT_EQ(b.job(1, -limit + behind - direction), direction > 0 ? 0x4104 : 0x4105);
    EXPECT_EQ(b.job(1, -limit + behind), kNoError);
  }
}

// POS-JOB-12, POS-JOB-13, POS-ERR-09
TEST(Jobs, BeforeARunOfTheSameCall) {
  Bench b(analogAxis());
  b.command.motion = quick();
  b.command.mode = 5;
  b.command.target = 5000;
  b.command.job = 1;
  b.command.jobRequest = b.command.start = true;
  EXPECT_EQ(b.call(), kNoError);
  EXPECT_TRUE(b.image().working);
  Bench failing(analogAxis());
  failing.command = b.command;
  failing.command.jobValue = 200'000'000;
  EXPECT_EQ(failing.call(), 0x3001);
  EXPECT_TRUE(failing.block.answer().jobError);
  EXPECT_FALSE(failing.image().working);
}

// POS-JOB-14, POS-ERR-44
TEST(Jobs, NotDuringARun) {
  Bench b(analogAxis());
  b.command.motion = quick();
  b.run(4, &Command::plus, 5000);
  b.cycles(10);
  EXPECT_EQ(b.job(1, 7), 0x4002);
  EXPECT_TRUE(b.image().working);
  EXPECT_EQ(b.image().lastTarget, 5000);
}

// POS-JOB-17
TEST(Jobs, NoDistanceToDelete) {
  Bench b(analogAxis());
  EXPECT_EQ(b.job(2, 4711), kNoError);
  EXPECT_FALSE(b.image().synchronous);
}

// POS-JOB-16: what has been reached stays
TEST(Jobs, DeletingKeepsPositionReached) {
  Bench b(analogAxis());
  b.command.motion = quick();
  b.run(4, &Command::plus, 5000);
  b.untilSet(&Image::positionReached);
  EXPECT_EQ(b.job(2), kNoError);
  EXPECT_TRUE(b.image().positionReached);
  EXPECT_EQ(b.image().distanceToGo, 0);
}

Bench measuring(io::LengthEdges edges) {
  io::AxisChannel p = analogAxis();
  p.lengthEdges = edges;
  Bench b(p);
  b.command.driveEnable = false;
  return b;
}

void edge(Bench& b, bool level, std::int64_t moved) {
  b.channel.move(moved);
  b.channel.lengthInput(level);
  b.cycle();
}

// POS-JOB-19, POS-JOB-23, POS-IF44-14: the workpiece of the bench, passed at full speed
TEST(Length, Workpiece) {
  io::AxisChannel p = analogAxis();
  p.lengthEdges = io::LengthEdges::RisingFalling;
  Bench b(p);
  b.command.motion = quick();
  b.run(4, &Command::plus, 5000);
  b.untilSet(&Image::measured);
  EXPECT_EQ(b.image().measureBegin, 1000);
  EXPECT_EQ(b.image().measureEnd, 1250);
  EXPECT_EQ(b.image().length, 250);
  b.untilReset(&Image::working);
  b.run(4, &Command::minus, 5000);
  b.until([&] { return !b.image().measured; });
  EXPECT_EQ(b.image().length, 250);  // POS-JOB-21
  b.untilSet(&Image::measured);
  EXPECT_EQ(b.image().measureBegin, 1249);
  EXPECT_EQ(b.image().measureEnd, 999);
}

// POS-JOB-20, POS-PARAM-18: what each kind of edges makes of 0 1 0 1 0, ten pulses apart
TEST(Length, Edges) {
  struct Row {
    io::LengthEdges edges;
    std::int32_t begin, end;
    int results;
  };
  for (const Row& row : {Row{io::LengthEdges::Off, 0, 0, 0},
                         {io::LengthEdges::Rising, 10, 30, 1},
                         {io::LengthEdges::Falling, 20, 40, 1},
                         {io::LengthEdges::RisingFalling, 30, 40, 2},
                         {io::LengthEdges::FallingRising, 20, 30, 1}}) {
    Bench b = measuring(row.edges);
    int results = 0;
    bool before = false;
    for (const bool level : {true, false, true, false}) {
      edge(b, level, 10);
      results += b.image().measured && !before ? 1 : 0;
      before = b.image().measured;
    }
    EXPECT_EQ(results, row.results);
    EXPECT_EQ(b.image().measureBegin, row.begin);
    EXPECT_EQ(b.image().measureEnd, row.end);
  }
}

// POS-JOB-20: the edge that ends a measurement does not begin the next one.
TEST(Length, OneAfterTheOther) {
  Bench b = measuring(io::LengthEdges::Rising);
  std::string done;
  for (int i = 0; i < 8; ++i) {
    edge(b, i % 2 == 0, 10);
    done += b.image().measured ? '1' : '0';
  }
  EXPECT_EQ(done, "00110011");
  EXPECT_EQ(b.image().measureBegin, 50);
  EXPECT_EQ(b.image().measureEnd, 70);
}

// POS-JOB-22, POS-JOB-24, POS-JOB-25
TEST(Length, ShiftAndTurn) {
  Bench b = measuring(io::LengthEdges::Rising);
  edge(b, true, 0);
  edge(b, false, 50);
  EXPECT_EQ(b.job(1, 70), kNoError);
  edge(b, true, 50);
  EXPECT_EQ(b.image().measureEnd, 120);
  EXPECT_EQ(b.image().length, 120);
  io::AxisChannel p = analogAxis();
  p.lengthEdges = io::LengthEdges::RisingFalling;
  p.rotary = true;
  p.rotaryEnd = 1000;
  Bench round(p);
  edge(round, true, 900);
  edge(round, false, 200);
  EXPECT_EQ(round.image().measureBegin, 900);
  EXPECT_EQ(round.image().measureEnd, 100);
  EXPECT_EQ(round.image().length, 200);
  edge(round, true, 1);
  round.channel.start();
  EXPECT_FALSE(round.image().measured);
  edge(round, false, 1);
  EXPECT_FALSE(round.image().measured);
}

}  // namespace
}  // namespace merker::positioning
