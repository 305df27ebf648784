// The instance data blocks of SFB 44 and SFB 46: names, addresses, types, start values (technology
// manual 3.8.4, 4.8.4).
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "program.h"
#include "system/library.h"

namespace merker::station::test {
namespace {

struct Row {
  std::string_view name, place;
  std::uint32_t initial;
  block::Section section;
};
constexpr auto kIn = block::Section::Input, kOut = block::Section::Output,
               kStat = block::Section::Static;

constexpr Row kAnalog[] = {
    {"LADDR", "DBW 0", 0x310, kIn},  // POS-IF44-01
    {"CHANNEL", "DBW 2", 0, kIn},    // POS-IF44-02
    {"DRV_EN", "DBX 4.0", 0, kIn},   // POS-IF44-03
    {"START", "DBX 4.1", 0, kIn},         {"DIR_P", "DBX 4.2", 0, kIn},
    {"DIR_M", "DBX 4.3", 0, kIn},         {"STOP", "DBX 4.4", 0, kIn},
    {"ERR_A", "DBX 4.5", 0, kIn},         {"MODE_IN", "DBW 6", 1, kIn},
    {"TARGET", "DBD 8", 1000, kIn},       {"SPEED", "DBD 12", 1000, kIn},
    {"WORKING", "DBX 16.0", 0, kOut},     {"POS_RCD", "DBX 16.1", 0, kOut},
    {"MSR_DONE", "DBX 16.2", 0, kOut},    {"SYNC", "DBX 16.3", 0, kOut},
    {"ACT_POS", "DBD 18", 0, kOut},       {"MODE_OUT", "DBW 22", 0, kOut},
    {"ERR", "DBW 24", 0, kOut},           {"ST_ENBLD", "DBX 26.0", 1, kOut},
    {"ERROR", "DBX 26.1", 0, kOut},       {"STATUS", "DBW 28", 0, kOut},
    {"ACCEL", "DBD 30", 100, kStat},      {"DECEL", "DBD 34", 100, kStat},
    {"CHGDIFF_P", "DBD 38", 1000, kStat}, {"CUTOFFDIFF_P", "DBD 42", 100, kStat},
    {"CHGDIFF_M", "DBD 46", 1000, kStat}, {"CUTOFFDIFF_M", "DBD 50", 100, kStat},
    {"PARA", "DBX 54.0", 0, kStat},       {"DIR", "DBX 54.1", 0, kStat},
    {"CUTOFF", "DBX 54.2", 0, kStat},     {"CHGOVER", "DBX 54.3", 0, kStat},
    {"RAMP_DN", "DBX 54.4", 0, kStat},    {"RAMP_UP", "DBX 54.5", 0, kStat},
    {"DIST_TO_GO", "DBD 56", 0, kStat},   {"LAST_TRG", "DBD 60", 0, kStat},
    {"BEG_VAL", "DBD 64", 0, kStat},      {"END_VAL", "DBD 68", 0, kStat},
    {"LEN_VAL", "DBD 72", 0, kStat},      {"JOB_REQ", "DBX 76.0", 0, kStat},
    {"JOB_DONE", "DBX 76.1", 1, kStat},   {"JOB_ERR", "DBX 76.2", 0, kStat},
    {"JOB_ID", "DBW 78", 0, kStat},       {"JOB_STAT", "DBW 80", 0, kStat},
    {"JOB_VAL", "DBD 82", 0, kStat}};

constexpr Row kDigital[] = {
    {"LADDR", "DBW 0", 0x310, kIn},  // POS-IF46-01
    {"CHANNEL", "DBW 2", 0, kIn},    // POS-IF46-02
    {"DRV_EN", "DBX 4.0", 0, kIn},        {"START", "DBX 4.1", 0, kIn},
    {"DIR_P", "DBX 4.2", 0, kIn},         {"DIR_M", "DBX 4.3", 0, kIn},
    {"STOP", "DBX 4.4", 0, kIn},          {"ERR_A", "DBX 4.5", 0, kIn},
    {"MODE_IN", "DBW 6", 1, kIn},         {"TARGET", "DBD 8", 1000, kIn},
    {"SPEED", "DBX 12.0", 0, kIn},  // POS-IF46-11
    {"WORKING", "DBX 14.0", 0, kOut},     {"POS_RCD", "DBX 14.1", 0, kOut},
    {"MSR_DONE", "DBX 14.2", 0, kOut},    {"SYNC", "DBX 14.3", 0, kOut},
    {"ACT_POS", "DBD 16", 0, kOut},       {"MODE_OUT", "DBW 20", 0, kOut},
    {"ERR", "DBW 22", 0, kOut},           {"ST_ENBLD", "DBX 24.0", 1, kOut},
    {"ERROR", "DBX 24.1", 0, kOut},       {"STATUS", "DBW 26", 0, kOut},
    {"CHGDIFF_P", "DBD 28", 1000, kStat}, {"CUTOFFDIFF_P", "DBD 32", 100, kStat},
    {"CHGDIFF_M", "DBD 36", 1000, kStat}, {"CUTOFFDIFF_M", "DBD 40", 100, kStat},
    {"PARA", "DBX 44.0", 0, kStat},       {"DIR", "DBX 44.1", 0, kStat},
    {"CUTOFF", "DBX 44.2", 0, kStat},     {"CHGOVER", "DBX 44.3", 0, kStat},
    {"DIST_TO_GO", "DBD 46", 0, kStat},   {"LAST_TRG", "DBD 50", 0, kStat},
    {"BEG_VAL", "DBD 54", 0, kStat},      {"END_VAL", "DBD 58", 0, kStat},
    {"LEN_VAL", "DBD 62", 0, kStat},      {"JOB_REQ", "DBX 66.0", 0, kStat},
    {"JOB_DONE", "DBX 66.1", 1, kStat},   {"JOB_ERR", "DBX 66.2", 0, kStat},
    {"JOB_ID", "DBW 68", 0, kStat},       {"JOB_STAT", "DBW 70", 0, kStat},
    {"JOB_VAL", "DBD 72", 0, kStat}};

void expectTable(std::uint16_t sfb, std::span<const Row> table, std::size_t length) {
  Plc plc("DATA_BLOCK DB 9 SFB " + std::to_string(sfb) +
          "\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  const block::Program library = system::library(defaultCpuModel());
  const auto& variables = library.at({BlockKind::SFB, sfb}).variables;
  ASSERT_EQ(variables.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Row& row = table[i];
    EXPECT_EQ(variables[i].name, row.name);
    EXPECT_EQ(variables[i].section, row.section) << row.name;
    EXPECT_EQ(plc.read("DB9." + std::string(row.place)), row.initial) << row.name;
    EXPECT_EQ(plc.reference("DB9." + std::string(row.name)).operand,
              plc.reference("DB9." + std::string(row.place)).operand)
        << row.name;
  }
  EXPECT_EQ(plc->program().at({BlockKind::DB, 9}).actualData.size(), length);
}

// POS-IF44-01, POS-IF44-02,
// POS-IF44-03, POS-IF44-04, POS-IF44-05, POS-IF44-06, POS-IF44-07, POS-IF44-08, POS-IF44-09,
// POS-IF44-10, POS-IF44-11, POS-IF44-12, POS-IF44-13, POS-IF44-14, POS-IF44-15, POS-IF44-16,
// POS-IF44-17, POS-IF44-18, POS-IF44-19, POS-IF44-20, POS-IF44-21, POS-IF44-22, POS-IF44-23,
// POS-IF44-24, POS-IF44-25, POS-IF44-26, POS-IF44-27, POS-IF44-28, POS-IF44-29, POS-IF44-30,
// POS-IF44-31, POS-IF44-32, POS-IF44-33, POS-IF44-34, POS-IF44-35, POS-IF44-36, POS-IF44-37,
// POS-IF44-38, POS-IF44-39, POS-IF44-40, POS-IF44-41, POS-IF44-42, POS-IF44-43, POS-IF44-44,
// POS-IF44-45, POS-IF44-46, POS-IF44-47, POS-OVW-11, POS-OVW-19
TEST(PositioningData, Analog) { expectTable(44, kAnalog, 86); }

// POS-IF46-01, POS-IF46-02, POS-IF46-03, POS-IF46-04, POS-IF46-05, POS-IF46-06, POS-IF46-07,
// POS-IF46-08, POS-IF46-09, POS-IF46-10, POS-IF46-11, POS-IF46-12, POS-IF46-13, POS-IF46-14,
// POS-IF46-15, POS-IF46-16, POS-IF46-17, POS-IF46-18, POS-IF46-19, POS-IF46-20, POS-IF46-21,
// POS-IF46-22, POS-IF46-23, POS-IF46-24, POS-IF46-25, POS-IF46-26, POS-IF46-27, POS-IF46-28,
// POS-IF46-29, POS-IF46-30, POS-IF46-31, POS-IF46-32, POS-IF46-33, POS-IF46-34, POS-IF46-35,
// POS-IF46-36, POS-IF46-37, POS-IF46-38, POS-IF46-39, POS-IF46-40, POS-IF46-41, POS-IF46-42,
// POS-IF46-43
TEST(PositioningData, Digital) { expectTable(46, kDigital, 76); }

// POS-OVW-02: loading and calling needs a CPU 314C-2.
TEST(PositioningData, OnlyTheCpu314CHasThem) {
  for (const char* name : {"312C", "313C", "313C-2 PtP", "313C-2 DP", "318-2", "312 IFM"})
    for (const std::uint16_t sfb : {std::uint16_t{44}, std::uint16_t{46}})
      EXPECT_FALSE(system::library(*findCpuModel(name)).contains({BlockKind::SFB, sfb})) << name;
  for (const char* name : {"314C-2 PtP", "314C-2 DP", "314C-2 PN/DP"})
    EXPECT_TRUE(system::library(*findCpuModel(name)).contains({BlockKind::SFB, 44})) << name;
}

}  // namespace
}  // namespace merker::station::test
