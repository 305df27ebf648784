#include "catalogue/cpu_model.h"

#include <gtest/gtest.h>

#include "catalogue/communication.h"

namespace merker {
namespace {

const CpuModel& model(std::string_view name) { return *findCpuModel(name); }

// S7-CPU-01
TEST(CpuModel, foundByKeywordOrName) {
  EXPECT_EQ(findCpuModel("314C-2 PtP"), &defaultCpuModel());
  EXPECT_EQ(findCpuModel("cpu314c-2ptp"), &defaultCpuModel());
  EXPECT_EQ(findCpuModel("CPU 314C-2 DP")->name, "CPU 314C-2 DP");
  EXPECT_EQ(findCpuModel("417-4"), nullptr);
  EXPECT_EQ(findCpuModel(""), nullptr);
}

// S7-CPU-02 to -11, -24 to -29
TEST(CpuModel, limitsOfThe314C) {
  const CpuModel& cpu = defaultCpuModel();
  EXPECT_EQ(cpu.workMemory, 49152u);
  EXPECT_EQ(cpu.dataBlockSize, 16384u);
  EXPECT_EQ(cpu.flagBytes, 256u);
  EXPECT_EQ(cpu.imageBytes, 128u);
  EXPECT_EQ(cpu.peripheralBytes, 1024u);
  EXPECT_EQ(cpu.timers, 256u);
  EXPECT_EQ(cpu.counters, 256u);
  EXPECT_EQ(cpu.localBytes, 510u);
  EXPECT_EQ(cpu.nesting, 8u);
  EXPECT_EQ(cpu.bracketDepth, 7u);
  EXPECT_EQ(cpu.cycleMonitoring, 150u);
  EXPECT_EQ(cpu.retentiveFlags, 16u);
  EXPECT_EQ(cpu.retentiveCounters, 8u);
  EXPECT_FALSE(cpu.hotRestart);  // S7-OPEN-43
}

// S7-LIM-05: every model has a row.
TEST(CpuModel, connections) {
  const auto of = [](std::string_view name) { return connectionLimits(model(name)).connections; };
  EXPECT_EQ(of("314C-2 PtP"), 12u);
  EXPECT_EQ(of("313C-2 DP"), 8u);
  EXPECT_EQ(of("312C"), 6u);
  EXPECT_EQ(of("312 IFM"), 4u);
  EXPECT_EQ(of("318-2"), 32u);
  EXPECT_EQ(of("generic"), 64u);
}

// S7-CPU-04
TEST(CpuModel, executionTimes) {
  EXPECT_EQ(defaultCpuModel().time(TimeClass::Bit), 100u);
  EXPECT_EQ(defaultCpuModel().time(TimeClass::Word), 200u);
  EXPECT_EQ(defaultCpuModel().time(TimeClass::Fixed), 2'000u);
  EXPECT_EQ(defaultCpuModel().time(TimeClass::Real), 20'000u);
}

// S7-CPU-08, -09, -10
TEST(CpuModel, blockNumbers) {
  const CpuModel& cpu = defaultCpuModel();
  EXPECT_TRUE(cpu.allows({BlockKind::DB, 127}));
  EXPECT_FALSE(cpu.allows({BlockKind::DB, 0}));
  EXPECT_FALSE(cpu.allows({BlockKind::DB, 128}));
  EXPECT_TRUE(cpu.allows({BlockKind::FB, 0}));
  EXPECT_FALSE(cpu.allows({BlockKind::FB, 128}));
  EXPECT_TRUE(cpu.allows({BlockKind::FC, 127}));
  EXPECT_FALSE(cpu.allows({BlockKind::FC, 128}));
  EXPECT_TRUE(model("generic").allows({BlockKind::DB, 65535}));
}

// S7-CPU-30
TEST(CpuModel, organizationBlocks) {
  for (const unsigned number : {1, 10, 20, 35, 40, 80, 81, 82, 85, 87, 100, 121, 122})
    EXPECT_TRUE(defaultCpuModel().hasOrganizationBlock(number)) << number;
  EXPECT_FALSE(defaultCpuModel().allows({BlockKind::OB, 101}));
  EXPECT_FALSE(defaultCpuModel().allows({BlockKind::OB, 0}));
  EXPECT_FALSE(defaultCpuModel().hasOrganizationBlock(86));
  EXPECT_TRUE(model("314C-2 DP").hasOrganizationBlock(86));
  EXPECT_TRUE(model("generic").allows({BlockKind::OB, 102}));
}

// S7-CPU-21: Z 32 and T 64 are too many
TEST(CpuModel, limitsOfThe312Ifm) {
  const CpuModel& cpu = model("312 IFM");
  EXPECT_EQ(cpu.workMemory, 6u * 1024);
  EXPECT_EQ(cpu.loadMemory, 20u * 1024);
  EXPECT_EQ(cpu.counters, 32u);
  EXPECT_EQ(cpu.timers, 64u);
  EXPECT_EQ(cpu.time(TimeClass::Bit), 600u);
  EXPECT_EQ(cpu.time(TimeClass::Real), 60'000u);
  EXPECT_EQ(cpu.analogChannels, 64u);
}

// S7-CPU-22
TEST(CpuModel, limitsOfThe318) {
  const CpuModel& cpu = model("318-2");
  EXPECT_EQ(cpu.workMemory, 256u * 1024);
  EXPECT_EQ(cpu.counters, 512u);
  EXPECT_EQ(cpu.timers, 512u);
  EXPECT_EQ(cpu.time(TimeClass::Real), 600u);
  EXPECT_EQ(cpu.digitalChannels, 65'536u);
  EXPECT_EQ(cpu.analogChannels, 4096u);
  EXPECT_TRUE(cpu.coldRestart);
}

// S7-CPU-11 to -14 of the 314C
TEST(CpuModel, hardwareOfThe314C) {
  EXPECT_EQ(defaultCpuModel().digitalChannels, 1016u);
  EXPECT_EQ(defaultCpuModel().analogChannels, 253u);
  EXPECT_EQ(defaultCpuModel().racks, 4u);
}

}  // namespace
}  // namespace merker
