#include "scenario/terminal_value.h"

#include <gtest/gtest.h>

#include "scenario/scenario.h"

namespace merker::simulator {
namespace {

// The CPU's own inputs and outputs, and an SM 331 called "Fill level" in slot 4.
io::Configuration hardware() {
  io::Module module;
  module.type = findModuleTypes("6ES7 331-7KF02-0AB0").at(0);
  module.slot = 4;
  module.name = "Fill level";
  module.parameters = io::Parameters::of(*module.type);
  module.parameters.analogInputs[1].range = nullptr;
  Problems problems;
  return io::configure({module}, defaultCpuModel(), problems);
}

// "1:7 P0980" of the only problem of a step, "" if there is none.
std::string problemOf(std::string text, bool withHardware = true) {
  const source::SourceFile file("a.scn", std::move(text));
  const io::Configuration configuration = hardware();
  Problems problems;
  for (Scenario& scenario : parseScenarios(file, problems))
    resolve(scenario, Resolver::Operands{}, problems, withHardware ? &configuration : nullptr);
  if (problems.empty()) return "";
  const Problem& problem = problems.list().front();
  return std::to_string(problem.position.line) + ":" + std::to_string(problem.position.column) +
         " " + std::string(problem.name());
}

TEST(TerminalSteps, faults) {
  EXPECT_EQ(problemOf("fault 4 wire break\n"), "");
  EXPECT_EQ(problemOf("fault \"fill level\" wire break channel 3 off\n"), "");
  EXPECT_EQ(problemOf("fault 2.2 load voltage off\n"), "");
  EXPECT_EQ(problemOf("fault 4 wirebreak\n"), "1:9 P0980");
  EXPECT_EQ(problemOf("fault 4\n"), "1:7 P0980");
  EXPECT_EQ(problemOf("fault 5 defect\n"), "1:7 P0981");
  EXPECT_EQ(problemOf("fault 2.2 removed\n"), "1:7 P0982");
  EXPECT_EQ(problemOf("fault 4 wire break channel 8\n"), "1:7 P0984");
  EXPECT_EQ(problemOf("fault 4 defect channel 1\n"), "1:7 P0984");
  EXPECT_EQ(problemOf("fault 4 defect\n", false), "1:7 P0983");
}

TEST(TerminalSteps, terminals) {
  EXPECT_EQ(problemOf("terminal 2.2.DI3 = 1, \"Fill level\".AI0 = 5V\n"), "");
  EXPECT_EQ(problemOf("expect terminal 2.3.AO1 <> 5V\n"), "");
  EXPECT_EQ(problemOf("terminal 2.2 = 1\n"), "1:10 P0952");
  EXPECT_EQ(problemOf("terminal 2.2.DI3\n"), "1:10 P0952");
  EXPECT_EQ(problemOf("terminal 2.2.DI24 = 1\n"), "1:10 P0984");
  EXPECT_EQ(problemOf("terminal 2.2.DI3 = 2\n"), "1:20 P0985");
  EXPECT_EQ(problemOf("terminal 4.AI0 = 5\n"), "1:18 P0985");
  EXPECT_EQ(problemOf("terminal 4.AI0 = 5mA\n"), "1:18 P0985");
  EXPECT_EQ(problemOf("terminal 4.AI1 = 5V\n"), "1:10 P0984");
  EXPECT_EQ(problemOf("terminal Nowhere.DI0 = 1\n"), "1:10 P0981");
}

// CNT-SIM-04: up to 100 kHz.
TEST(TerminalSteps, frequencies) {
  EXPECT_EQ(problemOf("pulses 2.2.DI0 100kHz\n"), "");
  EXPECT_EQ(problemOf("pulses 2.2.DI0 0.001Hz\n"), "");
  EXPECT_EQ(problemOf("pulses 2.2.DI0 100.001kHz\n"), "1:16 P0952");
  EXPECT_EQ(problemOf("pulses 2.2.DI0 0.0001Hz\n"), "1:16 P0952");
}

}  // namespace
}  // namespace merker::simulator
