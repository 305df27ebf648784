// Plants at the terminals of modules, in exact virtual time (PID-SIM-01, PID-SIM-03).
#include "plant/plants.h"

#include <gtest/gtest.h>

#include <cmath>

#include "make.h"

namespace merker::plant {
namespace {

// PID-SIM-03: one step or many, the state after a time is the same.
TEST(Plants, firstOrderIsExact) {
  for (const std::int64_t ms : {1, 10, 1000}) {
    PlantSettings oven = make("Oven", "first order", {{"gain", 2}, {"time_constant", 20}});
    oven.step = Duration::milliseconds(ms);
    Bench bench(oven);
    bench.set("LMN", 50);
    bench.wait(Duration::seconds(20));
    EXPECT_NEAR(bench.value("PV"), 100 * (1 - std::exp(-1.0)), 1e-9) << ms;
  }
}

TEST(Plants, deadTimeDelaysTheInput) {
  PlantSettings oven = make("Oven", "first order", {{"time_constant", 1}, {"dead_time", 2}});
  Bench bench(oven);
  bench.wait(Duration::seconds(1));
  bench.set("LMN", 100);
  bench.wait(Duration::seconds(2));
  EXPECT_EQ(bench.value("PV"), 0);
  bench.wait(Duration::seconds(1));
  EXPECT_NEAR(bench.value("PV"), 100 * (1 - std::exp(-1.0)), 0.1);
}

// PID-SIM-01: what a module puts out acts on the step that ends after it.
TEST(Plants, stepsTakeTheOutputsAtTheirEnd) {
  io::Rack rack(onBoard());
  rack.disableOutputs(false);
  PlantSettings oven = make("Oven", "first order", {{"time_constant", 0.001}});
  wire(oven, "LMN", *rack.terminal("2.3", io::Side::AnalogOutput, 0), 0.1);
  wire(oven, "PV", *rack.terminal("2.3", io::Side::AnalogInput, 2), 0.1);
  Plants plants(Configuration{{oven}});
  plants.advance(rack, at(0));
  EXPECT_EQ(plants.next(), at(1));
  const std::uint8_t full[] = {0x6C, 0x00};  // 27648: 10 V
  rack.written(*rack.configuration().find("2.3")->outputStart, full, 2);
  plants.advance(rack, at(1));
  EXPECT_NEAR(rack.amount(*rack.terminal("2.3", io::Side::AnalogInput, 2)),
              10 * (1 - std::exp(-1.0)), 1e-9);
  EXPECT_EQ(plants.next(), at(2));
}

// At the same instant a plant sees what those above it have just done.
TEST(Plants, plantsFeedPlants) {
  PlantSettings first = make("A", "first order", {{"time_constant", 0.001}});
  PlantSettings second = make("B", "first order", {{"time_constant", 0.001}, {"gain", 3}});
  second.wires.push_back({0, SignalPlace{0, *first.kind->signal("PV")}, "A.PV"});
  io::Rack rack(onBoard());
  Plants plants(Configuration{{first, second}});
  plants.set(rack, {0, 0}, 10, at(0));
  plants.advance(rack, at(1));
  const double one = 10 * (1 - std::exp(-1.0));
  EXPECT_NEAR(plants.value({1, *second.kind->signal("PV")}), 3 * one * (1 - std::exp(-1.0)), 1e-9);
}

}  // namespace
}  // namespace merker::plant
