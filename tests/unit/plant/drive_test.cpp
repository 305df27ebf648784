// Drives at a bus (S7-NET-22): the state machine of PROFIdrive, positions by telegram 9, speeds by
// telegram 1, faults.
#include <gtest/gtest.h>

#include "make.h"
#include "plant/drive_states.h"

namespace merker::plant {
namespace {

// STW1: control by PLC, no OFF2, no OFF3; ON; enable operation; and what a task needs.
constexpr int kReady = 0x0406, kOn = 0x0407, kOperation = 0x043F, kActivate = 0x0040,
              kAcknowledge = 0x0080, kHome = 0x0800;
constexpr int kFault = 1 << 3, kInhibited = 1 << 6, kReached = 1 << 10, kHomed = 1 << 11,
              kTaken = 1 << 12, kStandstill = 1 << 13;

class Axis {
 public:
  explicit Axis(std::vector<Given> given = {}, std::string_view kind = "positioning drive")
      : bench_(make("Axis", kind, std::move(given))) {}
  void control(int stw1) {
    bench_.set("STW1", stw1);
    wait(2);
  }
  void operate() { control(kReady), control(kOn), control(kOperation); }
  void set(std::string_view signal, double value) { bench_.set(signal, value); }
  void wait(int ms) { bench_.wait(Duration::milliseconds(ms)); }
  int word(std::string_view signal) { return static_cast<int>(bench_.value(signal)); }
  double value(std::string_view signal) { return bench_.value(signal); }
  bool status(int bits) { return (word("ZSW1") & bits) == bits; }
  // MDI with full acceleration.
  void travel(double target, int mode = 1) {
    set("SATZANW", 0x8000), set("MDI_MOD", mode), set("MDI_TARPOS", target);
    set("MDI_VELOCITY", 3000), set("MDI_ACC", 0x4000), set("MDI_DEC", 0x4000);  // 50000 LU/s
    control(kOperation), control(kOperation | kActivate);
  }

 private:
  Bench bench_;
};

struct Step {
  int stw1;
  bool stands;
  DriveState state;
  int low;  // bits 0 to 6 of ZSW1
};

// General state diagram of PROFIdrive.
TEST(DriveStates, FollowTheDiagram) {
  using enum DriveState;
  DriveStates states;
  const Step steps[] = {
      {0x0F, true, Inhibited, 0x70},        // ON at once is not enough
      {0x06, true, ReadyToSwitchOn, 0x31},  // OFF1 without OFF2, OFF3
      {0x07, true, SwitchedOn, 0x33},       {0x0F, true, Operation, 0x37},
      {0x07, false, SwitchedOn, 0x33},      {0x0F, false, Operation, 0x37},
      {0x0E, false, SwitchingOff, 0x33},  // OFF1: along the ramp
      {0x0F, false, Operation, 0x37},     // ON again
      {0x0E, false, SwitchingOff, 0x33},    {0x0E, true, ReadyToSwitchOn, 0x31},
      {0x0F, true, Operation, 0x37},        {0x0B, false, SwitchingOff, 0x13},  // OFF3
      {0x0F, false, SwitchingOff, 0x13},  // a quick stop ends in S1
      {0x0F, true, Inhibited, 0x70},        {0x0E, true, ReadyToSwitchOn, 0x31},
      {0x0F, true, Operation, 0x37},        {0x0D, false, Inhibited, 0x60},  // OFF2
      {0x0E, false, ReadyToSwitchOn, 0x31}, {0x02, true, Inhibited, 0x50},
  };
  for (const Step& step : steps) {
    states.step(static_cast<std::uint16_t>(step.stw1), step.stands);
    EXPECT_EQ(states.state(), step.state) << step.stw1;
    EXPECT_EQ(states.statusBits() & 0x7F, step.low) << step.stw1;
  }
}

TEST(DriveStates, AFaultStaysUntilItIsAcknowledged) {
  DriveStates states;
  for (const int word : {0x06, 0x0F}) states.step(static_cast<std::uint16_t>(word), true);
  states.fault(7860, StopReaction::Coast, false);
  states.fault(1910, StopReaction::Quick, false);
  EXPECT_EQ(states.faultNumber(), 7860);
  EXPECT_EQ(states.statusBits() & 0x7F, 0x78);
  states.step(0x06, true);
  EXPECT_EQ(states.state(), DriveState::Inhibited);
  states.step(0x86, true);  // the edge counts
  EXPECT_EQ(states.faultNumber(), 0);
  EXPECT_EQ(states.state(), DriveState::ReadyToSwitchOn);
}

// 50000 LU at 50000 LU/s with 500000 LU/s^2: 0.1 s up, 0.9 s, 0.1 s down.
TEST(PositioningDrive, TravelsToAPosition) {
  Axis axis({{"absolute", 1}, {"start", 0}});
  axis.operate();
  axis.travel(50'000);
  EXPECT_TRUE(axis.status(kTaken));
  EXPECT_EQ(axis.word("AKTSATZ"), 0x8000);
  axis.wait(550);
  EXPECT_NEAR(axis.value("POSITION"), 25'000, 150);
  EXPECT_EQ(axis.value("SPEED"), 50'000);
  EXPECT_FALSE(axis.status(kStandstill));
  axis.wait(540);
  EXPECT_FALSE(axis.status(kReached));
  axis.wait(20);
  EXPECT_TRUE(axis.status(kReached | kStandstill | kTaken));
  EXPECT_EQ(axis.value("XIST_A"), 50'000);
  axis.control(kOperation);
  EXPECT_FALSE(axis.status(kTaken));
  axis.travel(-10'000, 0);  // relative
  axis.wait(1000);
  EXPECT_EQ(axis.value("XIST_A"), 40'000);
}

TEST(PositioningDrive, StopsInBetweenAndGoesOn) {
  Axis axis({{"absolute", 1}, {"start", 0}});
  axis.operate();
  axis.travel(100'000);
  axis.wait(500);
  axis.control((kOperation | kActivate) & ~0x20);  // intermediate stop
  axis.wait(200);
  EXPECT_TRUE(axis.status(kStandstill));
  const double there = axis.value("POSITION");
  EXPECT_LT(there, 50'000);
  axis.control(kOperation | kActivate);
  axis.wait(3000);
  EXPECT_EQ(axis.value("POSITION"), 100'000);
  EXPECT_TRUE(axis.status(kReached));
  axis.travel(0);
  axis.wait(500);
  axis.control((kOperation | kActivate) & ~0x10);  // the task is rejected
  axis.wait(200);
  axis.control(kOperation | kActivate);
  axis.wait(3000);
  EXPECT_GT(axis.value("POSITION"), 50'000);
  EXPECT_FALSE(axis.status(kReached));
}

// Without a reference point no absolute position; the edge of the cam is position `home`.
TEST(PositioningDrive, FindsItsReferencePoint) {
  Axis axis({{"start", 30'000}, {"reference", 1000}, {"home", 500}});
  axis.operate();
  EXPECT_EQ(axis.value("XIST_A"), 0);
  axis.travel(20'000);
  EXPECT_FALSE(axis.status(kTaken));
  EXPECT_EQ(axis.value("WARNING"), 7461);
  axis.control(kOperation | kHome);
  axis.wait(4000);
  EXPECT_TRUE(axis.status(kHomed | kReached | kStandstill));
  EXPECT_EQ(axis.value("POSITION"), 1000);
  EXPECT_EQ(axis.value("XIST_A"), 500);
  EXPECT_EQ(axis.value("WARNING"), 0);
  axis.travel(20'000);
  axis.wait(2000);
  EXPECT_EQ(axis.value("POSITION"), 20'500);
}

TEST(PositioningDrive, ABlockOfItsOwnDoesNotExist) {
  Axis axis({{"absolute", 1}});
  axis.operate();
  axis.set("SATZANW", 3);
  axis.control(kOperation | kActivate);
  EXPECT_EQ(axis.value("WARNING"), 7462);
  EXPECT_TRUE(axis.status(kStandstill));
}

// It neither creeps nor travels backwards.
TEST(PositioningDrive, DoesNotTravelWithoutAVelocity) {
  for (const double velocity : {0.0, -3000.0}) {
    Axis axis({{"absolute", 1}, {"start", 0}});
    axis.operate();
    axis.set("SATZANW", 0x8000), axis.set("MDI_MOD", 1), axis.set("MDI_TARPOS", 20'000);
    axis.set("MDI_VELOCITY", velocity);
    axis.control(kOperation | kActivate);
    axis.wait(1000);
    EXPECT_EQ(axis.value("WARNING"), 7467);
    EXPECT_FALSE(axis.status(kTaken));
    EXPECT_EQ(axis.value("POSITION"), 0);
    axis.travel(20'000);
    axis.wait(2000);
    EXPECT_EQ(axis.value("POSITION"), 20'000);
    EXPECT_EQ(axis.value("WARNING"), 0);
  }
}

// F01910: it brakes as by OFF3, 2000000 LU/s^2, and needs an acknowledgement.
TEST(PositioningDrive, StopsWithoutItsMaster) {
  Axis axis({{"absolute", 1}, {"start", 0}});
  axis.operate();
  axis.travel(100'000);
  axis.wait(500);
  const double before = axis.value("POSITION");
  axis.set("BUS", 0);
  axis.wait(30);  // 25 ms from 50000 LU/s
  EXPECT_EQ(axis.value("SPEED"), 0);
  EXPECT_NEAR(axis.value("POSITION") - before, 625, 60);
  EXPECT_EQ(axis.value("FAULT"), 1910);
  EXPECT_TRUE(axis.status(kFault | kInhibited));
  axis.set("BUS", 1);
  axis.operate();
  EXPECT_EQ(axis.value("STATE"), 1);
  axis.control(kReady | kAcknowledge);
  axis.operate();
  EXPECT_EQ(axis.value("STATE"), 4);
}

// STW1.10: without it the telegram is not taken over, and the drive goes on.
TEST(PositioningDrive, KeepsItsSetpointsWithoutControlByThePlc) {
  Axis axis({{"absolute", 1}, {"start", 0}});
  axis.operate();
  axis.travel(100'000);
  axis.control(0);
  axis.wait(3000);
  EXPECT_EQ(axis.value("POSITION"), 100'000);
  EXPECT_EQ(axis.value("STATE"), 4);
}

TEST(PositioningDrive, ALimitSwitchStopsIt) {
  Axis axis({{"absolute", 1}, {"start", 300'000}});
  axis.operate();
  axis.travel(400'000);
  axis.wait(2000);
  EXPECT_EQ(axis.value("FAULT"), 7492);
  EXPECT_EQ(axis.value("HIGH_SWITCH"), 1);
  EXPECT_LT(axis.value("POSITION"), 321'000);
  axis.control(kReady | kAcknowledge);
  axis.operate();
  axis.control(kOperation | 0x100);  // jog back
  axis.wait(1000);
  EXPECT_EQ(axis.value("HIGH_SWITCH"), 0);
  EXPECT_EQ(axis.value("SPEED"), -5000);
  EXPECT_EQ(axis.value("FAULT"), 0);
}

TEST(PositioningDrive, BlockedItStopsWithAFollowingError) {
  Axis axis({{"absolute", 1}, {"start", 0}});
  axis.operate();
  axis.travel(100'000);
  axis.wait(200);
  axis.set("BLOCKED", 1);
  EXPECT_EQ(axis.value("FAULT"), 7452);
  EXPECT_EQ(axis.value("SPEED"), 0);
}

TEST(SpeedDrive, FollowsItsSetpoint) {
  Axis axis({{"start", 0}}, "speed drive");
  axis.set("NSOLL_A", 0x2000);  // 50 %
  axis.operate();
  axis.control(kOperation | 0x40);
  axis.wait(100);  // 50000 LU/s at 500000 LU/s^2
  EXPECT_EQ(axis.value("SPEED"), 50'000);
  EXPECT_EQ(axis.value("NIST_A"), 0x2000);
  axis.set("NSOLL_A", -0x4000);
  axis.wait(100);
  EXPECT_NEAR(axis.value("SPEED"), 0, 600);
  axis.control((kOperation | 0x40) & ~0x20);  // the ramp is frozen
  const double held = axis.value("SPEED");
  axis.wait(100);
  EXPECT_EQ(axis.value("SPEED"), held);
  axis.control(kOperation | 0x40);
  axis.wait(300);
  EXPECT_EQ(axis.value("NIST_A"), -0x4000);
  EXPECT_TRUE(axis.status(kReached));  // bit 10: the reference speed
  axis.control(kOperation & ~1);       // OFF1
  axis.wait(100);
  EXPECT_EQ(axis.value("STATE"), 5);
  axis.wait(110);
  EXPECT_EQ(axis.value("STATE"), 2);
}

}  // namespace
}  // namespace merker::plant
