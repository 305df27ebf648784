#include "scenario/plant_value.h"

#include <gtest/gtest.h>

#include "scenario/scenario.h"

namespace merker::simulator {
namespace {

plant::Configuration plants() {
  plant::PlantSettings oven{
      "Oven", plant::findKind("first order"), Duration::milliseconds(1), {}, {}};
  for (const plant::Parameter& parameter : oven.kind->parameters)
    oven.parameters.push_back(parameter.standard);
  oven.wires.push_back({0, io::Terminal{}, "2.3.AO0", 1, 0});
  plant::PlantSettings button{"Button", plant::findKind("bouncing switch"), {}, {5, 0.005, 0}, {}};
  return {{oven, button}};
}

std::string problemOf(std::string text, bool withPlants = true) {
  const source::SourceFile file("a.scn", std::move(text));
  const plant::Configuration configuration = plants();
  Problems problems;
  for (Scenario& scenario : parseScenarios(file, problems))
    resolve(scenario, Resolver::Operands{}, problems, nullptr,
            withPlants ? &configuration : nullptr);
  if (problems.empty()) return "";
  const Problem& problem = problems.list().front();
  return std::to_string(problem.position.line) + ":" + std::to_string(problem.position.column) +
         " " + std::string(problem.name());
}

TEST(PlantSteps, namesAndValues) {
  EXPECT_EQ(problemOf("plant oven.disturbance = -2.5, Button.PRESSED = TRUE\n"), "");
  EXPECT_EQ(problemOf("expect plant Oven.PV > 20 within 3s\n"), "");
  EXPECT_EQ(problemOf("plant Oven.DISTURBANCE = 1e308\n"), "1:26 P0989");
  EXPECT_EQ(problemOf("plant Oven.DISTURBANCE = TRUE\n"), "1:26 P0989");
  EXPECT_EQ(problemOf("plant Oven = 1\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Oven.OFFSET\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Oven.OFFSET = warm\n"), "1:21 P0989");
  EXPECT_EQ(problemOf("plant Button.PRESSED = 2\n"), "1:24 P0989");
  EXPECT_EQ(problemOf("plant Oven.HEAT = 1\n"), "1:7 P0762");
  EXPECT_EQ(problemOf("expect plant Stove.PV = 1\n"), "1:14 P0986");
  EXPECT_EQ(problemOf("plant Oven.PV = 1\n"), "1:7 P0988");
  EXPECT_EQ(problemOf("plant Oven.LMN = 1\n"), "1:7 P0988");
  EXPECT_EQ(problemOf("expect plant Oven.LMN = 1\n"), "");
  EXPECT_EQ(problemOf("plant Oven.OFFSET = 1\n", false), "1:7 P0987");
}

TEST(PlantSteps, faultsAndReset) {
  EXPECT_EQ(problemOf("plant Oven.PV stuck 80, Oven.LMN stuck, oven.pv free, Button reset\n"), "");
  EXPECT_EQ(problemOf("plant Button.CONTACT stuck 0.5\n"), "1:28 P0989");
  EXPECT_EQ(problemOf("plant Oven.PV stuck warm\n"), "1:21 P0989");
  EXPECT_EQ(problemOf("plant Oven stuck 1\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Oven.PV reset\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Oven.PV free 1\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Oven.PV burns\n"), "1:7 P0952");
  EXPECT_EQ(problemOf("plant Stove reset\n"), "1:7 P0986");
}

TEST(PlantSteps, comparesNumbers) {
  plant::Plants running(plants());
  Problems none;
  io::Rack rack(io::configure({}, defaultCpuModel(), none));
  PlantValue value;
  value.place = {0, 2};  // OFFSET
  value.number = 20;
  value.does = PlantValue::Does::Set;
  apply(value, running, rack, Instant{});
  EXPECT_EQ(running.value({0, 3}), 20);  // PV
  value.place = {0, 3};
  EXPECT_TRUE(holds(value, block::Relation::Equal, running));
  value.number = 20.00001;
  EXPECT_TRUE(holds(value, block::Relation::Equal, running));  // to seven digits
  EXPECT_FALSE(holds(value, block::Relation::NotEqual, running));
  EXPECT_TRUE(holds(value, block::Relation::About, running));
  EXPECT_TRUE(holds(value, block::Relation::Less, running));
  EXPECT_EQ(actualValue(value, running), "20");
}

}  // namespace
}  // namespace merker::simulator
