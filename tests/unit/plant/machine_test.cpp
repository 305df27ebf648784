// Vessel, garage door, traffic light, lift.
#include <gtest/gtest.h>

#include "make.h"

namespace merker::plant {
namespace {

// S7-VIS-05: 20 s from full to empty, sensors at 5 % and 95 %.
TEST(Vessel, sensorsFollowTheLevel) {
  Bench vessel(make("Vessel", "vessel"));
  EXPECT_EQ(vessel.value("MAX"), 1);
  vessel.set("OUTLET", 1);
  vessel.wait(Duration::milliseconds(1002));
  EXPECT_EQ(vessel.value("MAX"), 0);
  vessel.go(at(18990));
  EXPECT_EQ(vessel.value("MIN"), 1);
  vessel.go(at(19010));
  EXPECT_EQ(vessel.value("MIN"), 0);
  vessel.go(at(30000));
  EXPECT_EQ(vessel.value("LEVEL"), 0);
  vessel.set("INLET", 1);
  vessel.wait(Duration::seconds(5));
  EXPECT_EQ(vessel.value("LEVEL"), 0);  // both valves are open
  vessel.set("OUTLET", 0);
  vessel.wait(Duration::seconds(5));
  EXPECT_NEAR(vessel.value("LEVEL"), 25, 1e-9);
}

TEST(Vessel, stopIsNormallyClosed) {
  Bench vessel(make("Vessel", "vessel"));
  EXPECT_EQ(vessel.value("STOP_CONTACT"), 1);
  EXPECT_EQ(vessel.value("START_CONTACT"), 0);
  vessel.set("STOP", 1);
  vessel.set("START", 1);
  EXPECT_EQ(vessel.value("STOP_CONTACT"), 0);
  EXPECT_EQ(vessel.value("START_CONTACT"), 1);
}

TEST(GarageDoor, movesBetweenItsEndSwitches) {
  Bench door(make("Door", "garage door"));
  EXPECT_EQ(door.value("CLOSED"), 1);
  door.set("UP", 1);
  door.wait(Duration::seconds(5));
  EXPECT_NEAR(door.value("POSITION"), 50, 1e-9);
  EXPECT_EQ(door.value("CLOSED"), 0);
  door.set("DOWN", 1);
  door.wait(Duration::seconds(1));
  EXPECT_NEAR(door.value("POSITION"), 50, 1e-9);
  EXPECT_EQ(door.value("BOTH"), 1);
  door.set("DOWN", 0);
  door.wait(Duration::seconds(6));
  EXPECT_EQ(door.value("OPEN"), 1);
}

TEST(GarageDoor, stopsOnAnObstacleAndCountsOnce) {
  Bench door(make("Door", "garage door", {{"start", 100}}));
  door.set("OBSTACLE", 1);
  EXPECT_EQ(door.value("BARRIER"), 0);
  door.set("DOWN", 1);
  door.wait(Duration::seconds(20));
  EXPECT_EQ(door.value("POSITION"), 40);
  EXPECT_EQ(door.value("HITS"), 1);
  door.set("DOWN", 0);
  door.set("UP", 1);
  door.wait(Duration::seconds(1));
  door.set("UP", 0);
  door.set("DOWN", 1);
  door.wait(Duration::seconds(2));
  EXPECT_EQ(door.value("HITS"), 2);
  door.set("OBSTACLE", 0);
  door.wait(Duration::seconds(5));
  EXPECT_EQ(door.value("CLOSED"), 1);
  door.set("OBSTACLE", 1);  // in front of a closed door
  EXPECT_EQ(door.value("POSITION"), 0);
}

TEST(TrafficLight, countsDangers) {
  Bench light(make("Crossing", "traffic light"));
  light.set("CARS_GREEN", 1);
  light.set("WALK_RED", 1);
  EXPECT_EQ(light.value("DANGER"), 0);
  light.set("WALK_GREEN", 1);
  light.wait(Duration::seconds(1));
  EXPECT_EQ(light.value("DANGER"), 1);
  light.set("CARS_GREEN", 0);
  light.set("CARS_AMBER", 1);
  EXPECT_EQ(light.value("DANGER"), 2);
  light.set("LEFT", 1);
  EXPECT_EQ(light.value("LEFT_CONTACT"), 1);
  EXPECT_EQ(light.value("RIGHT_CONTACT"), 0);
}

TEST(Lift, floorsAndDoor) {
  Bench lift(make("Lift", "lift"));
  EXPECT_EQ(lift.value("FLOOR1"), 1);
  EXPECT_EQ(lift.value("DOOR_CLOSED"), 1);
  lift.set("UP", 1);
  lift.wait(Duration::seconds(1));
  EXPECT_EQ(lift.value("FLOOR1"), 0);
  lift.wait(Duration::seconds(3));
  EXPECT_EQ(lift.value("FLOOR2"), 1);
  EXPECT_NEAR(lift.value("HEIGHT"), 1, 1e-9);
  lift.set("UP", 0);
  lift.set("DOOR", 1);
  lift.wait(Duration::milliseconds(750));
  EXPECT_NEAR(lift.value("DOORWAY"), 50, 1e-9);
  lift.wait(Duration::seconds(1));
  EXPECT_EQ(lift.value("DOOR_OPEN"), 1);
  EXPECT_EQ(lift.value("FAULTS"), 0);
}

TEST(Lift, countsWhatMustNotHappen) {
  Bench lift(make("Lift", "lift"));
  lift.set("DOOR", 1);
  lift.wait(Duration::seconds(1));
  lift.set("UP", 1);
  lift.wait(Duration::milliseconds(10));
  EXPECT_EQ(lift.value("FAULTS"), 1);  // it moves with an open door
  lift.wait(Duration::seconds(1));
  EXPECT_EQ(lift.value("FAULTS"), 2);  // which is now open between two floors
  lift.set("DOOR", 0);
  lift.wait(Duration::seconds(20));
  EXPECT_EQ(lift.value("FAULTS"), 3);  // the buffer
}

}  // namespace
}  // namespace merker::plant
