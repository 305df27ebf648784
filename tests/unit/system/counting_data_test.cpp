// The instance data blocks of SFB 47, 48 and 49: names, addresses, initial values (technology
// manual 5.10.5).
#include <gtest/gtest.h>

#include <span>
#include <string>

#include "program.h"

namespace merker::station::test {
namespace {

struct Row {
  std::string_view name, place;
  std::uint32_t initial;
};

constexpr Row kCount[] = {
    {"LADDR", "DBW 0", 0x300},  // CNT-IF47-01
    {"CHANNEL", "DBW 2", 0},    // CNT-IF47-02
    {"SW_GATE", "DBX 4.0", 0},  // CNT-IF47-03
    {"CTRL_DO", "DBX 4.1", 0},   {"SET_DO", "DBX 4.2", 0},
    {"JOB_REQ", "DBX 4.3", 0},   {"JOB_ID", "DBW 6", 0},       // CNT-IF47-04
    {"JOB_VAL", "DBD 8", 0},     {"STS_GATE", "DBX 12.0", 0},  // CNT-IF47-05
    {"STS_STRT", "DBX 12.1", 0}, {"STS_LTCH", "DBX 12.2", 0},
    {"STS_DO", "DBX 12.3", 0},   {"STS_C_DN", "DBX 12.4", 0},
    {"STS_C_UP", "DBX 12.5", 0}, {"COUNTVAL", "DBD 14", 0},    // CNT-IF47-07
    {"LATCHVAL", "DBD 18", 0},   {"JOB_DONE", "DBX 22.0", 1},  // CNT-IF47-08
    {"JOB_ERR", "DBX 22.1", 0},  {"JOB_STAT", "DBW 24", 0},
    {"STS_CMP", "DBX 26.3", 0},  // CNT-IF47-09
    {"STS_OFLW", "DBX 26.5", 0}, {"STS_UFLW", "DBX 26.6", 0},
    {"STS_ZP", "DBX 26.7", 0},   {"JOB_OVAL", "DBD 28", 0},  // CNT-IF47-10
    {"RES_STS", "DBX 32.2", 0},  {"TIMEVAL", "DBD 34", 0}};  // CNT-IF47-14, CNT-OP-01

constexpr Row kFrequency[] = {
    {"LADDR", "DBW 0", 0x300},  // CNT-IF48-01
    {"CHANNEL", "DBW 2", 0},     {"SW_GATE", "DBX 4.0", 0},
    {"MAN_DO", "DBX 4.1", 0},    {"SET_DO", "DBX 4.2", 0},
    {"JOB_REQ", "DBX 4.3", 0},   {"JOB_ID", "DBW 6", 0},
    {"JOB_VAL", "DBD 8", 0},     {"STS_GATE", "DBX 12.0", 0},  // CNT-IF48-02
    {"STS_STRT", "DBX 12.1", 0}, {"STS_DO", "DBX 12.2", 0},
    {"STS_C_DN", "DBX 12.3", 0}, {"STS_C_UP", "DBX 12.4", 0},
    {"MEAS_VAL", "DBD 14", 0},                                 // CNT-IF48-03
    {"COUNTVAL", "DBD 18", 0},   {"JOB_DONE", "DBX 22.0", 1},  // CNT-IF48-04
    {"JOB_ERR", "DBX 22.1", 0},  {"JOB_STAT", "DBW 24", 0},
    {"STS_CMP", "DBX 26.3", 0},  // CNT-IF48-05
    {"STS_OFLW", "DBX 26.5", 0}, {"STS_UFLW", "DBX 26.6", 0},
    {"JOB_OVAL", "DBD 28", 0},   {"RES_STS", "DBX 32.2", 0}};

constexpr Row kPulse[] = {{"LADDR", "DBW 0", 0x300},                             // CNT-IF49-01
                          {"CHANNEL", "DBW 2", 0},     {"SW_EN", "DBX 4.0", 0},  // CNT-IF49-02
                          {"MAN_DO", "DBX 4.1", 0},    {"SET_DO", "DBX 4.2", 0},
                          {"OUTP_VAL", "DBW 6", 0},    {"JOB_REQ", "DBX 8.0", 0},  // CNT-IF49-03
                          {"JOB_ID", "DBW 10", 0},     {"JOB_VAL", "DBD 12", 0},
                          {"STS_EN", "DBX 16.0", 0},  // CNT-IF49-04
                          {"STS_STRT", "DBX 16.1", 0}, {"STS_DO", "DBX 16.2", 0},
                          {"JOB_DONE", "DBX 16.3", 1}, {"JOB_ERR", "DBX 16.4", 0},
                          {"JOB_STAT", "DBW 18", 0},   {"JOB_OVAL", "DBD 20", 0}};

void expectTable(int sfb, std::span<const Row> table, std::size_t length) {
  Plc plc("DATA_BLOCK DB 9 SFB " + std::to_string(sfb) +
          "\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nEND_ORGANIZATION_BLOCK\n");
  for (const Row& row : table) {
    EXPECT_EQ(plc.read("DB9." + std::string(row.place)), row.initial) << row.name;
    EXPECT_EQ(plc.reference("DB9." + std::string(row.name)).operand,
              plc.reference("DB9." + std::string(row.place)).operand)
        << row.name;
  }
  EXPECT_EQ(plc->program().at({BlockKind::DB, 9}).actualData.size(), length);
}

// CNT-IF47-14, CNT-OP-01
TEST(CountingData, Count) { expectTable(47, kCount, 38); }
// CNT-IF48-01, CNT-IF48-02, CNT-IF48-03, CNT-IF48-04, CNT-IF48-05
TEST(CountingData, Frequency) { expectTable(48, kFrequency, 34); }
// CNT-IF49-01, CNT-IF49-02, CNT-IF49-03, CNT-IF49-04
TEST(CountingData, Pulse) { expectTable(49, kPulse, 24); }

}  // namespace
}  // namespace merker::station::test
