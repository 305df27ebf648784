// The processes against their equations (PID-SIM-03 to PID-SIM-06, PID-SIM-08).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "make.h"

namespace merker::plant {
namespace {

Bench bench(std::string_view kind, std::vector<Given> given = {}, int stepMs = 100) {
  PlantSettings settings = make("It", kind, std::move(given));
  settings.step = Duration::milliseconds(stepMs);
  return Bench(settings);
}

// PID-SIM-03: the same seed, the same noise, within its bounds.
TEST(FirstOrder, noiseIsSeeded) {
  Bench one = bench("first order", {{"noise", 2}, {"seed", 7}});
  Bench same = bench("first order", {{"noise", 2}, {"seed", 7}});
  Bench other = bench("first order", {{"noise", 2}, {"seed", 8}});
  bool differs = false;
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    for (Bench* it : {&one, &same, &other}) it->wait(Duration::milliseconds(100));
    EXPECT_EQ(one.value("PV"), same.value("PV"));
    differs = differs || one.value("PV") != other.value("PV");
    largest = std::max(largest, std::abs(one.value("PV")));
  }
  EXPECT_TRUE(differs);
  EXPECT_LE(largest, 2);
  EXPECT_GT(largest, 1);
}

// PID-SIM-04: two lags in series, with a gain for each direction.
TEST(Temperature, heatsAndCools) {
  Bench oven = bench("temperature", {}, 1);
  oven.set("HEAT", 1);
  oven.wait(Duration::seconds(60));
  const double t = 60, t1 = 60, t2 = 10;
  const double rise = 1 - (t1 * std::exp(-t / t1) - t2 * std::exp(-t / t2)) / (t1 - t2);
  EXPECT_NEAR(oven.value("PV"), 20 + 300 * rise, 0.05);
  oven.set("HEAT", 0);
  oven.set("COOL", 1);
  oven.wait(Duration::seconds(2000));
  EXPECT_NEAR(oven.value("PV"), 20 - 150, 1e-6);
  oven.set("COOL", 0);
  oven.set("LMN", -10);
  oven.set("AMBIENT", 30);
  oven.wait(Duration::seconds(2000));
  EXPECT_NEAR(oven.value("PV"), 30 - 15, 1e-6);
}

TEST(Temperature, deadTime) {
  Bench oven = bench("temperature", {{"dead_time", 5}});
  oven.set("LMN", 100);
  oven.wait(Duration::milliseconds(5000));
  EXPECT_EQ(oven.value("PV"), 20);
  oven.wait(Duration::milliseconds(1000));
  EXPECT_GT(oven.value("PV"), 20);
}

// PID-SIM-05: the time of its way, and a backlash in which the motor turns in vain.
TEST(Valve, travelTimeAndBacklash) {
  Bench slow = bench("valve", {{"travel_time", 60}, {"start", 20}});
  slow.set("UP", 1);
  slow.wait(Duration::seconds(15));
  EXPECT_NEAR(slow.value("POSITION"), 45, 1e-9);
  Bench loose = bench("valve", {{"travel_time", 50}, {"backlash", 10}});
  loose.set("UP", 1);
  loose.wait(Duration::seconds(5));  // 10 %: the backlash
  EXPECT_NEAR(loose.value("POSITION"), 0, 1e-9);
  loose.wait(Duration::seconds(20));
  EXPECT_NEAR(loose.value("POSITION"), 40, 1e-9);
  loose.set("UP", 0);
  loose.set("DOWN", 1);
  loose.wait(Duration::seconds(5));
  EXPECT_NEAR(loose.value("POSITION"), 40, 1e-9);
  loose.wait(Duration::seconds(5));
  EXPECT_NEAR(loose.value("POSITION"), 30, 1e-9);
}

// PID-SIM-05: the position as an analog signal.
TEST(Valve, positionAtAnAnalogInput) {
  PlantSettings settings = make("It", "valve", {{"travel_time", 10}});
  settings.step = Duration::milliseconds(100);
  io::Rack rack(onBoard());
  const io::Terminal input = *rack.terminal("2.3", io::Side::AnalogInput, 0);
  wire(settings, "POSITION", input, 0.1);
  Plants plants(Configuration{{settings}});
  plants.advance(rack, {});
  const auto up = plants.configuration().plants[0].kind->signal("UP").value();
  plants.set(rack, {0, up}, 1, {});
  plants.advance(rack, at(2500));
  EXPECT_NEAR(rack.amount(input), 2.5, 1e-9);
  plants.advance(rack, at(60'000));
  EXPECT_NEAR(rack.amount(input), 10, 1e-9);
}

// PID-SIM-05, PID-CONS-22
TEST(Valve, movesBetweenItsStops) {
  Bench valve = bench("valve");
  EXPECT_EQ(valve.value("LMNR_LS"), 1);
  valve.set("UP", 1);
  valve.wait(Duration::seconds(15));
  EXPECT_NEAR(valve.value("POSITION"), 50, 1e-9);
  EXPECT_EQ(valve.value("LMNR_LS"), 0);
  valve.wait(Duration::seconds(20));
  EXPECT_EQ(valve.value("POSITION"), 100);
  EXPECT_EQ(valve.value("LMNR_HS"), 1);
  valve.set("DOWN", 1);
  EXPECT_EQ(valve.value("BOTH"), 1);
  valve.wait(Duration::seconds(3));
  EXPECT_EQ(valve.value("POSITION"), 100);
  valve.set("UP", 0);
  EXPECT_EQ(valve.value("BOTH"), 0);
  valve.wait(Duration::seconds(3));
  EXPECT_NEAR(valve.value("POSITION"), 90, 1e-9);
  valve.set("STUCK", 1);
  valve.wait(Duration::seconds(3));
  EXPECT_NEAR(valve.value("POSITION"), 90, 1e-9);
}

TEST(Valve, backlash) {
  Bench valve = bench("valve", {{"backlash", 5}, {"start", 50}});
  valve.set("UP", 1);
  valve.wait(Duration::seconds(1));
  EXPECT_EQ(valve.value("POSITION"), 50);  // the motor has turned 3.33 %
  valve.wait(Duration::seconds(2));
  EXPECT_NEAR(valve.value("POSITION"), 55, 1e-9);
  valve.set("UP", 0);
  valve.set("DOWN", 1);
  valve.wait(Duration::seconds(1));
  EXPECT_NEAR(valve.value("POSITION"), 55, 1e-9);
}

// PID-SIM-06
TEST(Tank, fillsAndDrains) {
  Bench tank = bench("tank", {{"capacity", 200}, {"inflow_rate", 4}, {"outflow_rate", 2}});
  EXPECT_EQ(tank.value("EMPTY"), 1);
  tank.set("INFLOW", 50);
  tank.wait(Duration::seconds(50));
  EXPECT_NEAR(tank.value("LEVEL"), 50, 1e-9);
  tank.set("DRAIN", 1);
  tank.wait(Duration::seconds(50));
  EXPECT_NEAR(tank.value("LEVEL"), 50, 1e-9);
  tank.set("FILL", 1);
  tank.wait(Duration::seconds(60));
  EXPECT_EQ(tank.value("LEVEL"), 100);
  EXPECT_EQ(tank.value("FULL"), 1);
}

// PID-SIM-08
TEST(Generator, stepRampAndSine) {
  Bench setpoint = bench("generator", {{"start", 10}});
  EXPECT_EQ(setpoint.value("VALUE"), 10);
  setpoint.set("TARGET", 20);
  EXPECT_EQ(setpoint.value("VALUE"), 20);
  setpoint.set("SLOPE", 2);
  setpoint.set("TARGET", 40);
  setpoint.wait(Duration::seconds(5));
  EXPECT_NEAR(setpoint.value("VALUE"), 30, 1e-9);
  setpoint.wait(Duration::seconds(50));
  EXPECT_EQ(setpoint.value("VALUE"), 40);
  Bench sine = bench("generator");
  sine.set("PERIOD", 8);
  sine.set("AMPLITUDE", 3);
  sine.wait(Duration::seconds(2));
  EXPECT_NEAR(sine.value("VALUE"), 3, 1e-9);
  sine.wait(Duration::seconds(1));
  EXPECT_NEAR(sine.value("VALUE"), 3 * std::sin(3 * std::numbers::pi / 4), 1e-9);
}

}  // namespace
}  // namespace merker::plant
