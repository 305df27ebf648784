// The configuration of a CPU as system data blocks (docs/formats/block.md).
#include "served/system_data.h"

#include "../hex.h"
#include "base/bytes.h"
#include "block/container.h"
#include "served/blocks.h"
#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::BlockType;
using s7comm::Error;

// Of the records of SDB 0 or 2; nothing: it has no such number.
std::optional<std::uint32_t> setting(const block::Program& all, std::uint16_t sdb,
                                     std::uint16_t number) {
  const Bytes& content = all.at({BlockKind::SDB, sdb}).actualData;
  for (std::size_t at = 0; at + 6 <= content.size(); at += 6)
    if (loadWord(&content[at]) == number) return loadDWord(&content[at + 2]);
  return std::nullopt;
}

TEST(SystemData, whatIsSetAndWhatTheModelHas) {
  CpuParameters cpu = CpuParameters::of(defaultCpuModel());
  cpu.cycleMonitoring = 400;
  cpu.clockMemory = 100;
  cpu.password = "SECRET";
  cpu.cyclic = {{35, 50, 5}};
  cpu.timeOfDay = {{10, true, 0x0201, 86'400'000}};
  const block::Program all = systemData(defaultCpuModel(), cpu, nullptr);
  EXPECT_EQ(all.size(), 2u);
  EXPECT_EQ(setting(all, 0, 1), 400u);
  EXPECT_EQ(setting(all, 2, 1), 150u);
  EXPECT_EQ(setting(all, 0, 4), 100u);
  EXPECT_EQ(setting(all, 2, 4), 0xFFFFu);
  EXPECT_EQ(setting(all, 0, 0x123), 50u);
  EXPECT_EQ(setting(all, 0, 0x223), 5u);
  EXPECT_EQ(setting(all, 0, 0x30A), 0x1'0201u);
  EXPECT_EQ(setting(all, 0, 0x40A), 86'400u);
  EXPECT_EQ(setting(all, 2, 0x123), std::nullopt);
  const Bytes& content = all.at({BlockKind::SDB, 0}).actualData;
  EXPECT_EQ(std::string(content.begin(), content.end()).find("SECRET"), std::string::npos);
}

TEST(SystemData, modules) {
  io::Configuration hardware;
  io::Module& module = hardware.modules.emplace_back();
  module.type = findModuleTypes("6ES7 321-1BH02-0AA0").at(0);
  module.rack = 1, module.slot = 4;
  module.inputStart = 32;
  const auto all = systemData(defaultCpuModel(), {}, &hardware);
  EXPECT_EQ(toHex(all.at({BlockKind::SDB, 1}).actualData),
            "01 04 00 00 36 45 53 37 20 33 32 31 2D 31 42 48 30 32 2D 30 41 41 30 20 "
            "00 20 00 02 FF FF 00 00");
}

// Listed beside the program, fetched like any block.
TEST(SystemData, theDirectoryHasThem) {
  ServedPlc plc = ServedPlc::station();
  const auto all = blocksOf(plc.plc());
  ASSERT_TRUE(all);
  std::vector<std::uint16_t> numbers;
  for (const auto& one : *all) {
    if (one.type != BlockType::Sdb) continue;
    numbers.push_back(one.number);
    EXPECT_EQ(one.language, 7);
  }
  EXPECT_EQ(numbers, (std::vector<std::uint16_t>{0, 2}));
  const Uploaded fetched = upload(plc.plc(), {}, {BlockType::Sdb, 0});
  ASSERT_EQ(fetched.error, Error::None);
  const auto block = block::readContainer(fetched.container, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->id, (BlockId{BlockKind::SDB, 0}));
  EXPECT_EQ(block->actualData,
            systemData(defaultCpuModel(), CpuParameters::of(defaultCpuModel()), nullptr)
                .at({BlockKind::SDB, 0})
                .actualData);
  EXPECT_EQ(upload(plc.plc(), {}, {BlockType::Sdb, 1}).error, Error::NoSuchBlock);
  EXPECT_EQ(upload(plc.plc(), {}, {BlockType::Sdb, 0, s7comm::FileSystem::Passive}).error,
            Error::NoSuchBlock);
}

}  // namespace
}  // namespace merker::served
