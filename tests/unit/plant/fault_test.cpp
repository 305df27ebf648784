// Stuck sensors and actuators, and reset, of any kind of plant.
#include <gtest/gtest.h>

#include "make.h"

namespace merker::plant {
namespace {

constexpr std::uint32_t kOutlet = 1, kStart = 4, kLevel = 6, kMin = 7;

struct Wired {
  Wired() {
    PlantSettings vessel = make("Vessel", "vessel");
    wire(vessel, "OUTLET", *rack.terminal("2.2", io::Side::DigitalOutput, 0));
    wire(vessel, "MIN", minimum);
    wire(vessel, "START_CONTACT", button);
    plants = std::make_unique<Plants>(Configuration{{vessel}});
    rack.disableOutputs(false);
  }
  void open(bool on) {
    const std::uint8_t byte = on;
    rack.written(*rack.configuration().find("2.2")->outputStart, &byte, 1);
  }
  io::Rack rack{onBoard()};
  io::Terminal minimum = *rack.terminal("2.2", io::Side::DigitalInput, 0);
  io::Terminal button = *rack.terminal("2.2", io::Side::DigitalInput, 1);
  std::unique_ptr<Plants> plants;
};

TEST(PlantFault, aStuckSensorShowsItsValueUntilItIsFree) {
  Wired it;
  it.plants->advance(it.rack, at(0));
  EXPECT_TRUE(it.rack.level(it.minimum));
  it.plants->stick(it.rack, {0, kMin}, 0, at(10));
  EXPECT_FALSE(it.rack.level(it.minimum));
  EXPECT_EQ(it.plants->value({0, kMin}), 0);
  EXPECT_EQ(it.plants->stuck({0, kMin}), 0);
  it.plants->release(it.rack, {0, kMin}, at(20));
  EXPECT_TRUE(it.rack.level(it.minimum));
  EXPECT_FALSE(it.plants->stuck({0, kMin}));
}

TEST(PlantFault, aStuckValveDoesNotMove) {
  Wired it;
  it.plants->stick(it.rack, {0, kOutlet}, std::nullopt, at(0));  // closed as it is
  it.open(true);
  it.plants->advance(it.rack, at(1000));
  EXPECT_EQ(it.plants->value({0, kLevel}), 100);
  it.plants->release(it.rack, {0, kOutlet}, at(1000));
  it.plants->advance(it.rack, at(2000));
  EXPECT_NEAR(it.plants->value({0, kLevel}), 95, 0.01);
  it.plants->stick(it.rack, {0, kOutlet}, 1, at(2000));
  it.open(false);
  it.plants->advance(it.rack, at(3000));
  EXPECT_NEAR(it.plants->value({0, kLevel}), 90, 0.01);
}

TEST(PlantFault, aStuckInputRemembersWhatItWasTold) {
  Wired it;
  it.plants->stick(it.rack, {0, kStart}, 0, at(0));
  it.plants->set(it.rack, {0, kStart}, 1, at(1));
  EXPECT_FALSE(it.rack.level(it.button));
  it.plants->release(it.rack, {0, kStart}, at(2));
  EXPECT_TRUE(it.rack.level(it.button));
}

TEST(PlantFault, resetGoesBackToTheBeginning) {
  Wired it;
  it.open(true);
  it.plants->stick(it.rack, {0, kMin}, 0, at(0));
  it.plants->set(it.rack, {0, kStart}, 1, at(0));
  it.plants->advance(it.rack, at(5000));
  it.open(false);
  it.plants->reset(it.rack, 0, at(5000));
  EXPECT_EQ(it.plants->value({0, kLevel}), 100);
  EXPECT_EQ(it.plants->value({0, kStart}), 0);
  EXPECT_FALSE(it.plants->stuck({0, kMin}));
  EXPECT_TRUE(it.rack.level(it.minimum));
  EXPECT_FALSE(it.rack.level(it.button));
  EXPECT_EQ(it.plants->next(), at(5001));
}

// What somebody else lays at a terminal stays until the sensor changes.
TEST(PlantFault, terminalsAreSetByChangesOnly) {
  Wired it;
  it.plants->advance(it.rack, at(0));
  it.rack.setLevel(it.minimum, false, at(1));
  it.plants->advance(it.rack, at(100));
  EXPECT_FALSE(it.rack.level(it.minimum));
}

}  // namespace
}  // namespace merker::plant
