// SFB 42 CONT_S: the instance data block of table 7.5.2, its functions, and the reference traces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "loop.h"

namespace merker::station::test {
namespace {

struct Row {
  std::string_view name, place;
  std::uint32_t initial;
};

constexpr std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

// Table of the manual.
constexpr Row kTable[] = {{"COM_RST", "DBX 0.0", 0},     {"LMNR_HS", "DBX 0.1", 0},
                          {"LMNR_LS", "DBX 0.2", 0},     {"LMNS_ON", "DBX 0.3", 1},
                          {"LMNUP", "DBX 0.4", 0},       {"LMNDN", "DBX 0.5", 0},
                          {"PVPER_ON", "DBX 0.6", 0},    {"CYCLE", "DBD 2", 1000},
                          {"SP_INT", "DBD 6", 0},        {"PV_IN", "DBD 10", 0},
                          {"PV_PER", "DBW 14", 0},       {"GAIN", "DBD 16", bits(2)},
                          {"TI", "DBD 20", 20'000},      {"DEADB_W", "DBD 24", bits(1)},
                          {"PV_FAC", "DBD 28", bits(1)}, {"PV_OFF", "DBD 32", 0},
                          {"PULSE_TM", "DBD 36", 3000},  {"BREAK_TM", "DBD 40", 3000},
                          {"MTR_TM", "DBD 44", 30'000},  {"DISV", "DBD 48", 0},
                          {"QLMNUP", "DBX 52.0", 0},     {"QLMNDN", "DBX 52.1", 0},
                          {"PV", "DBD 54", 0},           {"ER", "DBD 58", 0},
                          {"INTEGRAL", "DBD 62", 0},     {"THRESHOLD", "DBD 66", 0},
                          {"DIRECTION", "DBW 70", 0},    {"PULSE_LEFT", "DBD 72", 0},
                          {"BREAK_LEFT", "DBD 76", 0}};

Loop automatic() {
  Loop loop(42);
  loop.set("LMNS_ON", false);
  return loop;
}

// U up, D down, . neither
std::string outputs(Loop& loop, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    loop.call();
    const bool up = loop.flag("QLMNUP"), down = loop.flag("QLMNDN");
    EXPECT_FALSE(up && down);
    text += up ? 'U' : down ? 'D' : '.';
  }
  return text;
}

std::string repeat(char c, std::size_t count) { return std::string(count, c); }

// PID-CONS-01, PID-CONS-02, PID-CONS-03, PID-CONS-04, PID-CONS-05, PID-CONS-06, PID-CONS-07
TEST(ContS, instanceDataBlock) {
  Loop loop(42);
  for (const Row& row : kTable) {
    EXPECT_EQ(loop.at(row.place), row.initial) << row.name;
    EXPECT_EQ(loop.plc().reference("DB41." + std::string(row.name)).operand,
              loop.plc().reference("DB41." + std::string(row.place)).operand)
        << row.name;
  }
  EXPECT_EQ(loop.plc()->program().at({BlockKind::DB, 41}).actualData.size(), 80u);
}

// PID-CONS-10
TEST(ContS, errorAndDeadBand) {
  Loop loop = automatic();
  loop.set("SP_INT", 11.0);
  loop.call();
  EXPECT_EQ(loop.real("ER"), 10);
  loop.set("PVPER_ON", true);
  loop.set("PV_PER", 13824);
  loop.call();
  EXPECT_EQ(loop.real("PV"), 50);
  EXPECT_EQ(loop.real("ER"), -38);
}

// PID-CONS-11, PID-CONS-12, PID-CONS-13, PID-CONS-20, PID-OP-11
TEST(ContS, referenceTrace) {
  Loop loop = automatic();
  loop.set("SP_INT", 11.0);
  const float kIntegral[] = {-1, 1.333F,  3.667F,  6,  8.333F, 10.667F,
                             13, 15.333F, 17.667F, 20, 19,     18};
  std::string is;
  for (int i = 0; i < 40; ++i) {
    is += outputs(loop, 1);
    if (i < 12) {
      EXPECT_NEAR(loop.real("INTEGRAL"), kIntegral[i], 0.001) << i;
    }
    if (i == 0) {
      EXPECT_EQ(loop.real("THRESHOLD"), 10);  // 3 s of 30 s
    }
  }
  const std::string should = repeat('U', 9) + repeat('.', 10) + repeat('U', 4) + repeat('.', 10) +
                             repeat('U', 4) + repeat('.', 9);
  EXPECT_EQ(is.substr(0, should.size()), should.substr(0, 40));
}

// PID-CONS-21
TEST(ContS, movesAtTheSpeedOfItsIntegral) {
  Loop loop = automatic();
  loop.set("SP_INT", 11.0);
  const std::string trace = outputs(loop, 600);
  const auto up = static_cast<double>(std::count(trace.begin(), trace.end(), 'U'));
  EXPECT_NEAR(up * 100 / 30 / 600, 1.0, 0.05);  // % of the way a second
}

// PID-CONS-13: with a short pulse the least threshold is 100 x PULSE_TM / MTR_TM.
TEST(ContS, leastThreshold) {
  Loop loop = automatic();
  loop.set("CYCLE", 100);
  loop.set("PULSE_TM", 500);
  loop.call();
  EXPECT_NEAR(loop.real("THRESHOLD"), 1.6667, 1e-4);
}

// PID-CONS-14, PID-CONS-04, PID-CONS-05, PID-CONS-06
TEST(ContS, pulsesAndPausesAreLongEnough) {
  Loop loop = automatic();
  std::mt19937 random(42);
  std::uniform_real_distribution<float> setpoint(-60, 60);
  loop.set("GAIN", 4.0);
  std::string trace;
  for (int i = 0; i < 150; ++i) {
    loop.set("SP_INT", setpoint(random));
    trace += outputs(loop, 4);
  }
  std::size_t runs = 0;
  for (std::size_t begin = 0, end = 0; begin < trace.size(); begin = end, ++runs) {
    end = std::min(trace.find_first_not_of(trace[begin], begin), trace.size());
    if (begin == 0 || end == trace.size()) continue;
    EXPECT_GE(end - begin, 3u) << begin;                    // PULSE_TM, BREAK_TM
    EXPECT_TRUE(trace[begin] == '.' || trace[end] == '.');  // no reversal without a pause
  }
  EXPECT_GT(runs, 20u);
}

// PID-CONS-15
TEST(ContS, stopsActAtOnce) {
  Loop loop = automatic();
  loop.set("SP_INT", -50.0);
  EXPECT_EQ(outputs(loop, 1), "D");
  loop.set("LMNR_LS", true);
  EXPECT_EQ(outputs(loop, 5), ".....");
  const float held = loop.real("INTEGRAL");
  loop.call();
  EXPECT_EQ(loop.real("INTEGRAL"), held);  // nothing adds up against the stop
  loop.set("SP_INT", 50.0);
  loop.set("LMNR_LS", false);
  loop.set("LMNR_HS", true);
  EXPECT_EQ(outputs(loop, 6), "......");
}

// PID-CONS-16
TEST(ContS, manual) {
  Loop loop(42);
  loop.set("LMNUP", true);
  std::string trace = outputs(loop, 1);
  loop.set("LMNUP", false);
  trace += outputs(loop, 6);
  EXPECT_EQ(trace, "UUU....");  // PULSE_TM counts here too
  EXPECT_EQ(loop.real("INTEGRAL"), 0);
  loop.set("LMNUP", true);
  loop.set("LMNDN", true);
  EXPECT_EQ(outputs(loop, 3), "...");
  loop.set("LMNUP", false);
  EXPECT_EQ(outputs(loop, 2), "DD");
}

// PID-CONS-17, PID-CONS-22: as a position controller.
TEST(ContS, positions) {
  Loop loop = automatic();
  loop.set("TI", 0);
  loop.set("DEADB_W", 0.0);
  loop.set("GAIN", 1.0);
  loop.set("SP_INT", 50.0);
  loop.set("CYCLE", 100);
  loop.set("PULSE_TM", 500);
  loop.set("BREAK_TM", 500);
  EXPECT_EQ(outputs(loop, 400), repeat('U', 150) + repeat('.', 250));
  EXPECT_NEAR(loop.real("INTEGRAL"), 50, 0.001);
}

// PID-CONS-18
TEST(ContS, closesUntilTheStop) {
  Loop loop = automatic();
  loop.set("TI", 0);
  loop.set("PV_IN", 2.0);
  loop.set("GAIN", 10.0);
  loop.set("CYCLE", 100);
  EXPECT_EQ(outputs(loop, 500), repeat('D', 500));
  loop.set("LMNR_LS", true);
  EXPECT_EQ(outputs(loop, 3), "...");
}

// PID-CONS-19
TEST(ContS, restart) {
  Loop loop = automatic();
  loop.set("SP_INT", 50.0);
  EXPECT_EQ(outputs(loop, 2), "UU");
  loop.set("COM_RST", true);
  EXPECT_EQ(outputs(loop, 1), ".");
  EXPECT_EQ(loop.real("ER"), 0);
  EXPECT_EQ(loop.real("INTEGRAL"), 0);
}

TEST(ContS, strangeTimes) {  // PID-OP-08
  Loop loop = automatic();
  loop.set("SP_INT", 60.0);
  loop.set("MTR_TM", 0);  // as one call: the least threshold is 100 %
  loop.set("PULSE_TM", 100);
  EXPECT_EQ(outputs(loop, 1), "U");
  loop.set("CYCLE", -5);
  EXPECT_EQ(outputs(loop, 1), "U");  // as it was
  EXPECT_EQ(loop.plc()->mode(), Mode::Run);
}

// PID-EX-05: valve and first-order process, in the order call, valve, process.
TEST(ContS, controlsAProcessThroughAValve) {
  Loop loop = automatic();
  loop.set("CYCLE", 100);
  loop.set("PULSE_TM", 500);
  loop.set("BREAK_TM", 500);
  loop.set("GAIN", 1.0);
  loop.set("DEADB_W", 0.5);
  loop.set("SP_INT", 50.0);
  const struct {
    int call;
    double pv, position;
  } kRows[] = {{50, 2.35, 16.67},    {100, 8.60, 33.33},  {200, 29.29, 61.33},
               {300, 45.08, 49.33},  {400, 49.80, 45.33}, {600, 52.05, 43.67},
               {1000, 50.78, 42.00}, {3000, 50.40, 42.00}};
  double pv = 0, position = 0;
  const auto* row = std::begin(kRows);
  for (int k = 0; row != std::end(kRows); ++k) {
    if (k == row->call) {
      EXPECT_NEAR(pv, row->pv, 0.05) << k;
      EXPECT_NEAR(position, row->position, 0.05) << k;
      ++row;
    }
    loop.set("PV_IN", pv);
    loop.call();
    const double way = 100.0 / 300;
    if (loop.flag("QLMNUP")) position = std::min(100.0, position + way);
    if (loop.flag("QLMNDN")) position = std::max(0.0, position - way);
    pv += (1 - std::exp(-0.1 / 20)) * (1.2 * position - pv);
  }
}

}  // namespace
}  // namespace merker::station::test
