// SFB 43 PULSEGEN: the instance data block of table 7.5.3, modes, least pulses, synchronisation.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "loop.h"

namespace merker::station::test {
namespace {

struct Row {
  std::string_view name, place;
  std::uint32_t initial;
};

constexpr std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

// Table of the manual.
constexpr Row kTable[] = {{"INV", "DBD 0", 0},         {"PER_TM", "DBD 4", 1000},
                          {"P_B_TM", "DBD 8", 50},     {"RATIOFAC", "DBD 12", bits(1)},
                          {"STEP3_ON", "DBX 16.0", 1}, {"ST2BI_ON", "DBX 16.1", 0},
                          {"MAN_ON", "DBX 16.2", 0},   {"POS_P_ON", "DBX 16.3", 0},
                          {"NEG_P_ON", "DBX 16.4", 0}, {"SYN_ON", "DBX 16.5", 1},
                          {"COM_RST", "DBX 16.6", 0},  {"CYCLE", "DBD 18", 10},
                          {"QPOS_P", "DBX 22.0", 0},   {"QNEG_P", "DBX 22.1", 0},
                          {"CALL_INDEX", "DBW 24", 0}, {"CALLS_ON", "DBW 26", 0},
                          {"SIGN", "DBW 28", 0},       {"INV_OLD", "DBD 30", 0},
                          {"HAS_OLD", "DBX 34.0", 0}};

// P positive, N negative pulse, . neither, ! both
std::string outputs(Loop& loop, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    loop.call();
    const bool positive = loop.flag("QPOS_P"), negative = loop.flag("QNEG_P");
    text += positive && negative ? '!' : positive ? 'P' : negative ? 'N' : '.';
  }
  return text;
}

Loop tenCalls(double value) {
  Loop loop(43);
  loop.set("CYCLE", 100);
  loop.set("INV", value);
  return loop;
}

// A value on a fresh block: "30 P" on-calls of a period of 100 calls.
struct Mode43 {
  bool step3 = true, bipolar = false;
  double ratio = 1;
};
std::string period(const Mode43& mode, double value) {
  Loop loop(43);
  loop.set("STEP3_ON", mode.step3);
  loop.set("ST2BI_ON", mode.bipolar);
  loop.set("RATIOFAC", mode.ratio);
  loop.set("INV", value);
  const std::string trace = outputs(loop, 100);
  const auto p = std::count(trace.begin(), trace.end(), 'P');
  const auto n = std::count(trace.begin(), trace.end(), 'N');
  if (!mode.step3) return std::to_string(p) + " P " + std::to_string(n) + " N";
  return p > 0 ? std::to_string(p) + " P" : n > 0 ? std::to_string(n) + " N" : "0";
}

// PID-PULS-01, PID-PULS-02, PID-PULS-03, PID-PULS-04, PID-PULS-05
TEST(PulseGenerator, instanceDataBlock) {
  Loop loop(43);
  for (const Row& row : kTable) {
    EXPECT_EQ(loop.at(row.place), row.initial) << row.name;
    EXPECT_EQ(loop.plc().reference("DB41." + std::string(row.name)).operand,
              loop.plc().reference("DB41." + std::string(row.place)).operand)
        << row.name;
  }
  EXPECT_EQ(loop.plc()->program().at({BlockKind::DB, 41}).actualData.size(), 36u);
}

// PID-PULS-10, PID-PULS-13
TEST(PulseGenerator, pulseAtTheBeginningOfThePeriod) {
  Loop heating = tenCalls(30), cooling = tenCalls(-30);
  EXPECT_EQ(outputs(heating, 20), "PPP.......PPP.......");
  EXPECT_EQ(outputs(cooling, 20), "NNN.......NNN.......");
}

// PID-PULS-11, PID-PULS-14, PID-PULS-06
TEST(PulseGenerator, threeSteps) {
  EXPECT_EQ(period({}, 30), "30 P");
  EXPECT_EQ(period({}, 4), "0");
  EXPECT_EQ(period({}, 5), "5 P");
  EXPECT_EQ(period({}, 95), "95 P");
  EXPECT_EQ(period({}, 96), "100 P");
  EXPECT_EQ(period({}, -96), "100 N");
  EXPECT_EQ(period({}, 150), "100 P");
  EXPECT_EQ(period({true, true}, 30), "30 P");  // ST2BI_ON does not matter (PID-PULS-12)
}

// PID-PULS-15
TEST(PulseGenerator, ratioBelowOne) {
  const Mode43 half{true, false, 0.5};
  EXPECT_EQ(period(half, 40), "40 P");
  EXPECT_EQ(period(half, -40), "20 N");
  EXPECT_EQ(period(half, -9), "5 N");
  EXPECT_EQ(period(half, -5), "3 N");
  EXPECT_EQ(period(half, -4.9), "0");
  EXPECT_EQ(period(half, -200), "100 N");
}

// PID-PULS-16, PID-OP-04, PID-OP-06
TEST(PulseGenerator, ratioAboveOne) {
  const Mode43 twice{true, false, 2};
  EXPECT_EQ(period(twice, 40), "20 P");
  EXPECT_EQ(period(twice, -40), "40 N");
  EXPECT_EQ(period(twice, 5), "3 P");
  EXPECT_EQ(period(twice, 4.9), "0");
  EXPECT_EQ(period(twice, 200), "100 P");
}

// PID-PULS-12, PID-PULS-17
TEST(PulseGenerator, twoSteps) {
  const Mode43 bipolar{false, true}, unipolar{false, false};
  EXPECT_EQ(period(bipolar, -100), "0 P 100 N");
  EXPECT_EQ(period(bipolar, -95), "0 P 100 N");
  EXPECT_EQ(period(bipolar, -50), "25 P 75 N");
  EXPECT_EQ(period(bipolar, 0), "50 P 50 N");
  EXPECT_EQ(period(bipolar, 50), "75 P 25 N");
  EXPECT_EQ(period(bipolar, 100), "100 P 0 N");
  EXPECT_EQ(period(unipolar, 0), "0 P 100 N");
  EXPECT_EQ(period(unipolar, 30), "30 P 70 N");
  EXPECT_EQ(period(unipolar, 100), "100 P 0 N");
  EXPECT_EQ(period({false, false, 0.5}, 30), "30 P 70 N");
}

// PID-PULS-18
TEST(PulseGenerator, manual) {
  const struct {
    bool step3, positive, negative;
    std::string_view output;
  } kRows[] = {{true, false, false, "."}, {true, true, false, "P"},   {true, false, true, "N"},
               {true, true, true, "."},   {false, false, false, "N"}, {false, false, true, "N"},
               {false, true, false, "P"}, {false, true, true, "P"}};
  Loop loop = tenCalls(100);
  loop.set("MAN_ON", true);
  for (const auto& row : kRows) {
    loop.set("STEP3_ON", row.step3);
    loop.set("POS_P_ON", row.positive);
    loop.set("NEG_P_ON", row.negative);
    EXPECT_EQ(outputs(loop, 1), row.output);
  }
}

// PID-PULS-19
TEST(PulseGenerator, automaticBeginsAPeriod) {
  Loop loop = tenCalls(30);
  outputs(loop, 5);
  loop.set("MAN_ON", true);
  outputs(loop, 1);
  loop.set("MAN_ON", false);
  EXPECT_EQ(outputs(loop, 10), "PPP.......");
}

// The trace of 24 calls with INV 30, and 60 before this call.
std::string changedBefore(int call, bool synchronise = true) {
  Loop loop = tenCalls(30);
  loop.set("SYN_ON", synchronise);
  const std::string before = outputs(loop, call - 1);
  loop.set("INV", 60.0);
  return before + outputs(loop, 24 - call + 1);
}

// PID-PULS-20, PID-PULS-21, PID-PULS-22, PID-PULS-23
TEST(PulseGenerator, synchronisation) {
  EXPECT_EQ(changedBefore(5), "PPP..PPPPPP....PPPPPP...");
  EXPECT_EQ(changedBefore(9), "PPP.......PPPPPP....PPPP");
  EXPECT_EQ(changedBefore(11), "PPP.......PPPPPP....PPPP");  // the first of a period
  EXPECT_EQ(changedBefore(8).substr(0, 10), "PPP.....PP");
  EXPECT_EQ(changedBefore(5, false), "PPP.......PPPPPP....PPPP");
}

// PID-PULS-24
TEST(PulseGenerator, restart) {
  Loop loop = tenCalls(30);
  loop.set("STEP3_ON", false);
  EXPECT_EQ(outputs(loop, 5), "PPPNN");
  loop.set("COM_RST", true);
  EXPECT_EQ(outputs(loop, 2), "..");
  loop.set("COM_RST", false);
  EXPECT_EQ(outputs(loop, 4), "PPPN");
}

// PID-PULS-25, PID-OP-05
TEST(PulseGenerator, periodsThatAreNoMultiple) {
  Loop loop = tenCalls(50);
  loop.set("CYCLE", 300);
  EXPECT_EQ(outputs(loop, 6), "PP.PP.");
  loop.set("PER_TM", 1);
  EXPECT_EQ(loop.plc()->mode(), Mode::Run);
}

TEST(PulseGenerator, strangeValues) {  // PID-OP-08
  Loop loop = tenCalls(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(outputs(loop, 2), "..");
  loop.set("CYCLE", 0);
  loop.set("INV", 50.0);
  EXPECT_EQ(outputs(loop, 2), "..");
}

// PID-EX-02: heating and cooling with 50 calls a period.
TEST(PulseGenerator, heatingAndCooling) {
  for (const double value : {30.0, -30.0}) {
    Loop loop(43);
    loop.set("CYCLE", 20);
    loop.set("P_B_TM", 40);
    loop.set("INV", value);
    EXPECT_EQ(outputs(loop, 50), std::string(15, value > 0 ? 'P' : 'N') + std::string(35, '.'));
  }
}

}  // namespace
}  // namespace merker::station::test
