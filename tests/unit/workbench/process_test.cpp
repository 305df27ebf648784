#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kProcessSettings = R"(
[[module]]
type = "6ES7 331-7KF02-0AB0"
slot = 4
name = "Analog"

[[plant]]
name = "Oven"
kind = "first order"
time_constant = "1s"
wire = { PV = "Analog.AI0" }
)";

Json valueOf(const Json& plant, const std::string& name) {
  for (const Json& value : plant["values"])
    if (value["name"] == name) return value;
  return nullptr;
}

TEST(Process, WithoutPlantsThereIsNothing) {
  Bench bench;
  EXPECT_EQ(bench.call("process.list")["plants"], Json::array());
  bench.call("process.watch", {{"on", true}});
  EXPECT_EQ(bench.event("process")["plants"], Json::object());
  EXPECT_EQ(bench.problem("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 1}}),
            "P0987");
}

TEST(Process, InputsAreSetAndOutputsMove) {
  Bench bench(kProgram, kProcessSettings);
  const Json oven = bench.call("process.list")["plants"][0];
  EXPECT_EQ(oven["name"], "Oven");
  EXPECT_EQ(oven["kind"], "first order");
  EXPECT_EQ(oven["parameters"]["time_constant"], 1);
  EXPECT_EQ(valueOf(oven, "LMN")["writable"], true);
  EXPECT_EQ(valueOf(oven, "PV")["writable"], false);
  EXPECT_EQ(valueOf(oven, "PV")["operand"], "PEW 256");
  EXPECT_EQ(valueOf(oven, "LMN")["operand"], "");
  bench.call("process.watch", {{"on", true}});
  EXPECT_EQ(bench.event("process")["plants"]["Oven"]["PV"], 0);
  bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 80}});
  bench.run(Duration::seconds(10));
  const Json event = bench.event("process");
  EXPECT_NEAR(event["plants"]["Oven"]["PV"].get<double>(), 80, 1);
  EXPECT_EQ(bench.problem("process.set", {{"plant", "Oven"}, {"value", "PV"}, {"to", 1}}), "P0988");
  EXPECT_EQ(bench.problem("process.set", {{"plant", "Door"}, {"value", "PV"}, {"to", 1}}), "P0986");
  bench.call("process.watch", {{"on", false}});
  bench.run(Duration::seconds(1));
  EXPECT_TRUE(bench.event("process").is_null());
}

// Pressed as long as the pointer holds it: nobody holds it when the page is gone.
TEST(Process, WhatABrowserHeldIsLetGoWhenItHasGone) {
  for (const bool held : {true, false}) {
    Bench bench(kProgram, kProcessSettings);
    bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 30}, {"held", held}});
    bench.workbench.closed(1);
    const Json oven = bench.call("process.list")["plants"][0];
    EXPECT_EQ(valueOf(oven, "LMN")["value"], held ? 0.0 : 30.0);
  }
}

TEST(Process, AValueBeyondItsRangeIsRefused) {
  Bench bench(kProgram, kProcessSettings);
  const auto set = [&](double to) {
    return bench.ask("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", to}});
  };
  EXPECT_TRUE(set(100).contains("result"));
  const Json refused = set(100.5);
  EXPECT_EQ(refused["problems"][0]["code"], "P0989");
  EXPECT_NE(refused["problems"][0]["text"].get<std::string>().find("from 0 to 100"),
            std::string::npos);
  EXPECT_TRUE(set(-1).contains("problems"));
  EXPECT_EQ(bench.problem("process.fault",
                          {{"plant", "Oven"}, {"fault", "PV"}, {"on", true}, {"to", 1e6}}),
            "P0989");
  EXPECT_EQ(valueOf(bench.call("process.list")["plants"][0], "LMN")["value"], 100);
}

// S7-VIS-03: an actuator that the program switches is back as a sensor within 50 ms and a cycle.
TEST(Process, AnActuatorComesBackAsASensorInTime) {
  Bench bench(kProgram, R"(
[[module]]
type = "6ES7 321-1BH02-0AA0"
slot = 4
name = "In"

[[module]]
type = "6ES7 322-1BH01-0AA0"
slot = 5
name = "Out"

[[plant]]
name = "Relay"
kind = "bouncing switch"
bounces = 0
step = "10ms"
wire = { PRESSED = "Out.DO8", CONTACT = "In.DI9" }
)");
  const auto value = [&](const char* operand) -> std::string {
    return bench.call("variables.read", {{"items", {{{"operand", operand}}}}})["items"][0]["text"];
  };
  ASSERT_EQ(value("E 1.1"), "0");
  bench.call("variables.write", {{"items", {{{"operand", "A 5.0"}, {"value", "1"}}}}});
  controller::Controller& plc = bench.workbench.plc()->controller();
  const Instant switched = plc.now();
  while (value("E 1.1") == "0" && plc.now() < switched + Duration::seconds(1)) plc.advanceCycles(1);
  EXPECT_EQ(value("E 1.1"), "1");
  EXPECT_LE((plc.now() - switched).ns, Duration::milliseconds(51).ns);
}

TEST(Process, SensorsStickAndPlantsBeginAgain) {
  Bench bench(kProgram, kProcessSettings);
  bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 80}});
  bench.run(Duration::seconds(10));
  bench.call("process.fault", {{"plant", "Oven"}, {"fault", "PV"}, {"on", true}});
  bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 0}});
  bench.run(Duration::seconds(10));
  Json oven = bench.call("process.list")["plants"][0];
  EXPECT_EQ(oven["faults"][0]["name"], "PV");
  EXPECT_EQ(oven["faults"][0]["on"], true);
  bench.call("process.watch", {{"on", true}});
  EXPECT_NEAR(bench.event("process")["stuck"]["Oven"]["PV"].get<double>(), 80, 1);
  bench.call("process.fault", {{"plant", "Oven"}, {"fault", "PV"}, {"on", true}, {"to", 12}});
  EXPECT_EQ(valueOf(bench.call("process.list")["plants"][0], "PV")["stuck"], 12);
  bench.call("process.fault", {{"plant", "Oven"}, {"fault", "PV"}, {"on", true}, {"to", 80}});
  oven = bench.call("process.list")["plants"][0];
  EXPECT_NEAR(valueOf(oven, "PV")["value"].get<double>(), 80, 1);
  bench.call("process.fault", {{"plant", "Oven"}, {"fault", "PV"}, {"on", false}});
  EXPECT_NEAR(valueOf(bench.call("process.list")["plants"][0], "PV")["value"].get<double>(), 0, 1);
  bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 80}});
  bench.run(Duration::seconds(10));
  bench.call("process.reset", {{"plant", "Oven"}});
  oven = bench.call("process.list")["plants"][0];
  EXPECT_NEAR(valueOf(oven, "PV")["value"].get<double>(), 0, 1);
  EXPECT_EQ(bench.problem("process.fault", {{"plant", "Oven"}, {"fault", "XX"}, {"on", true}}),
            "P0762");
  EXPECT_EQ(bench.problem("process.reset", {{"plant", "Door"}}), "P0986");
}

TEST(Process, CurvesShowPlantsToo) {
  Bench bench(kProgram, kProcessSettings);
  const Json items = Json::array({Json{{"operand", "plant.Oven.PV"}}});
  bench.call("trend.set", {{"list", 1}, {"items", items}, {"everyMs", 100}});
  bench.call("process.set", {{"plant", "Oven"}, {"value", "LMN"}, {"to", 80}});
  bench.run(Duration::seconds(5));
  const Json rows = bench.event("samples")["rows"];
  EXPECT_LT(rows[0][1], 20);
  EXPECT_GT(rows.back()[1], 70);
}

}  // namespace
}  // namespace merker::workbench::test
