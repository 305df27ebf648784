#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

Settings readHardware(std::string text, const CpuModel* model = nullptr) {
  Problems problems;
  const std::optional<Model> chosen = model ? std::optional(Model{model, nullptr}) : std::nullopt;
  Settings settings =
      readSettings(source::SourceFile("merker.toml", std::move(text)), problems, chosen);
  for (const Problem& problem : problems.list()) ADD_FAILURE() << problem.message;
  return settings;
}

TEST(Hardware, withoutTablesThereIsNone) {
  EXPECT_FALSE(readHardware("[cpu]\nmodel = \"314C-2 DP\"\n").hardware.has_value());
  EXPECT_EQ(readHardware("[hardware]\n").hardware->modules.size(), 4u);
}

// S7-HWCFG-08
TEST(Hardware, everyCpuParameter) {
  const CpuParameters p = readHardware(R"([cpu]
cycle_monitoring = "300ms"
minimum_cycle = "20ms"
communication_load = 30
clock_memory = 100
retentive_flags = 32
retentive_timers = 4
retentive_counters = 16
start_on_mismatch = false
image_errors = "coming and going"
protection = 3
password = "secret"
[cpu.OB35]
interval = "50ms"
phase = "5ms"
[cpu.OB10]
period = "minute"
start = "DT#1994-01-01-00:00:30"
)")
                              .parameters;
  EXPECT_EQ(p.cycleMonitoring, 300u);
  EXPECT_EQ(p.minimumCycle, 20u);
  EXPECT_EQ(p.communicationLoad, 30u);
  EXPECT_EQ(p.clockMemory, 100u);
  EXPECT_EQ(p.retentiveFlags, 32u);
  EXPECT_EQ(p.retentiveTimers, 4u);
  EXPECT_EQ(p.retentiveCounters, 16u);
  EXPECT_FALSE(p.startOnMismatch);
  EXPECT_EQ(p.imageErrors, ImageErrors::ComingAndGoing);
  EXPECT_EQ(p.protection, 3);
  EXPECT_EQ(p.password, "secret");
  ASSERT_EQ(p.cyclic.size(), 1u);
  EXPECT_EQ(p.cyclic[0].ob, 35);
  EXPECT_EQ(p.cyclic[0].interval, 50);
  EXPECT_EQ(p.cyclic[0].phase, 5);
  ASSERT_EQ(p.timeOfDay.size(), 1u);
  EXPECT_TRUE(p.timeOfDay[0].active);
  EXPECT_EQ(p.timeOfDay[0].period, 0x0201);
  EXPECT_EQ(p.timeOfDay[0].start, defaultStartOfClock() + 30'000);
}

// S7-HWCFG-03, S7-HWCFG-09
TEST(Hardware, everyModuleParameter) {
  const Settings settings = readHardware(R"(
[[module]]
slot = 2.2
name = "Panel"
input = 0
output = 0
input_delay = "0.1ms"
rising_edge = [0, 1]
falling_edge = 23
[[module]]
slot = 4
type = "SM 331 AI8x12bit"
input = 300
diagnostics = true
range = "±5V"
[[module.channel]]
input = 0
range = "4..20mA"
wire_break = true
upper_limit = "18mA"
lower_limit = "6mA"
[[module.channel]]
input = 1
range = "4..20mA"
[[module.channel]]
input = 7
range = "off"
[[module]]
slot = 5
type = "SM 332 AO4x12bit"
on_stop = "substitute"
[[module.channel]]
output = 1
range = "0..10V"
substitute = "2.5V"
[[module]]
slot = 6
type = "6ES7322-8BF00-0AB0"
output = 8
on_stop = "substitute"
substitute = [0, 7]
)");
  const io::Configuration& hardware = *settings.hardware;
  const io::Parameters& panel = hardware.find("panel")->parameters;
  EXPECT_EQ(hardware.find("panel")->inputStart, 0u);
  EXPECT_EQ(panel.inputDelay, Duration::microseconds(100));
  EXPECT_EQ(panel.risingEdges, 3u);
  EXPECT_EQ(panel.fallingEdges, 1u << 23);
  const io::Parameters& inputs = hardware.find("4")->parameters;
  EXPECT_EQ(hardware.find("4")->inputStart, 300u);
  EXPECT_TRUE(inputs.diagnosticInterrupt);
  EXPECT_EQ(inputs.analogInputs[0].range->name, "4..20mA");
  EXPECT_TRUE(inputs.analogInputs[0].wireBreakCheck);
  EXPECT_EQ(inputs.analogInputs[0].upperLimit, 18);
  EXPECT_EQ(inputs.analogInputs[2].range->name, "±5V");
  EXPECT_EQ(inputs.analogInputs[7].range, nullptr);
  const io::Parameters& outputs = hardware.find("5")->parameters;
  EXPECT_EQ(outputs.onStop, io::OnStop::Substitute);
  EXPECT_EQ(outputs.analogOutputs[1].substitute, 2.5);
  EXPECT_EQ(hardware.find("6")->parameters.substituteBits, 0x81u);
  EXPECT_EQ(hardware.find("6")->outputStart, 8u);
}

TEST(Hardware, modelOfTheCommandLine) {
  const Settings settings =
      readHardware("[cpu]\nmodel = \"314C-2 PtP\"\n[hardware]\n", findCpuModel("312C"));
  EXPECT_EQ(settings.model->name, "CPU 312C");
  EXPECT_EQ(settings.hardware->modules.size(), 2u);
}

}  // namespace
}  // namespace merker::project
