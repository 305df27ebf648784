// What only some PLCs can do is asked for by what it is, never by the family: a step that needs
// something else than the PLC has is refused with its name.
#include <gtest/gtest.h>

#include "compilation/build.h"
#include "plc/machine_code.h"
#include "scenario/runner.h"

namespace merker::compilation {
namespace {

using controller::capability;
using controller::MachineCode;

Build built(const std::string& name, const std::string& text) {
  return build(project::load(name, {}, {{name, text}}), false);
}

Build control() { return built("a.s5", "OB 1\n      L     KF +1\n      T     MW 10\n      BE\n"); }
Build station() {
  return built("a.awl",
               "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 1;\nT MW 10;\nL 2;\nT MW 12;\n"
               "END_ORGANIZATION_BLOCK\n");
}

// The failures of a scenario, resolved against the terminals that a CPU 314C-2 PtP has on board.
std::vector<std::string> failures(const Build& build, const std::string& text) {
  const source::SourceFile file("t.scn", text);
  Problems problems;
  auto scenarios = simulator::parseScenarios(file, problems);
  const io::Configuration hardware = io::configure({}, defaultCpuModel(), problems);
  simulator::resolve(scenarios.at(0), build.operands(), problems, &hardware);
  for (const Problem& problem : problems.list()) ADD_FAILURE() << source::format(problem, &file);
  const auto plc = build.controller();
  std::vector<std::string> messages;
  for (const auto& failure : simulator::runScenario(scenarios[0], *plc).failures)
    messages.push_back(failure.message);
  return messages;
}

TEST(Capabilities, aStepIsRefusedForWhatThePlcLacks) {
  const std::pair<std::string, std::string> rows[] = {
      {"switch RUN", "mode switch"},
      {"expect LED SF = on within 1s", "LEDs"},
      {"hot restart", "hot restart"},
      {"remove card", "slot for a memory card"},
      {"copy RAM to ROM", "load memory beside its RAM"},
      {"trigger OB 82 coming", "events that can be triggered"},
      {"terminal 2.2.DI0 = 1", "modules with terminals"},
      {"expect terminal 2.2.DI0 = 1", "modules with terminals"},
      {"pulses 2.2.DI0 1kHz", "modules with terminals"}};
  const Build build = control();
  for (const auto& [step, lacking] : rows)
    EXPECT_EQ(failures(build, step + "\nstop\n"),
              std::vector{step + ": SINUMERIK 810 GA3 has no " + lacking});
}

TEST(Capabilities, aStepIsCarriedOutByWhoeverHasThem) {
  const std::string steps =
      "switch RUN\nexpect LED SF = off\nswitch STOP\ncopy RAM to ROM\nremove card\n"
      "memory reset\nexpect mode = STOP\n";
  EXPECT_EQ(failures(station(), steps), std::vector<std::string>{});
  EXPECT_EQ(failures(station(), "battery low\nbattery good\n"), std::vector<std::string>{});
  EXPECT_EQ(failures(control(), "battery low\nbattery good\n"), std::vector<std::string>{});
}

// Both have it: the answer is that of the machine, not of its family.
TEST(Capabilities, machineCodeIsThereWhenItIsOn) {
  for (const Build& build : {control(), station()}) {
    const auto plc = build.controller();
    auto* const code = capability<MachineCode>(*plc);
    ASSERT_NE(code, nullptr) << plc->modelName();
    EXPECT_FALSE(code->compiled());
    EXPECT_EQ(code->compiledBytes(), 0u);
    if (!code->setCompiled(true)) GTEST_SKIP() << "no compiler for this processor";
    code->translateNow();
    EXPECT_TRUE(code->compiled());
    EXPECT_GT(code->compiledBytes(), 0u) << plc->modelName();
    EXPECT_TRUE(code->setCompiled(false));
    EXPECT_FALSE(code->compiled());
    EXPECT_EQ(code->compiledBytes(), 0u) << plc->modelName();
  }
}

}  // namespace
}  // namespace merker::compilation
