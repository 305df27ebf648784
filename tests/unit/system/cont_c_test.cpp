// SFB 41 CONT_C: the instance data block of the manual's table 7.5.1, its functions one by one, and
// the traces of the requirements.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
constexpr Row kTable[] = {{"COM_RST", "DBX 0.0", 0},
                          {"MAN_ON", "DBX 0.1", 1},
                          {"PVPER_ON", "DBX 0.2", 0},
                          {"P_SEL", "DBX 0.3", 1},
                          {"I_SEL", "DBX 0.4", 1},
                          {"INT_HOLD", "DBX 0.5", 0},
                          {"I_ITL_ON", "DBX 0.6", 0},
                          {"D_SEL", "DBX 0.7", 0},
                          {"CYCLE", "DBD 2", 1000},
                          {"SP_INT", "DBD 6", 0},
                          {"PV_IN", "DBD 10", 0},
                          {"PV_PER", "DBW 14", 0},
                          {"MAN", "DBD 16", 0},
                          {"GAIN", "DBD 20", bits(2)},
                          {"TI", "DBD 24", 20'000},
                          {"TD", "DBD 28", 10'000},
                          {"TM_LAG", "DBD 32", 2000},
                          {"DEADB_W", "DBD 36", 0},
                          {"LMN_HLM", "DBD 40", bits(100)},
                          {"LMN_LLM", "DBD 44", 0},
                          {"PV_FAC", "DBD 48", bits(1)},
                          {"PV_OFF", "DBD 52", 0},
                          {"LMN_FAC", "DBD 56", bits(1)},
                          {"LMN_OFF", "DBD 60", 0},
                          {"I_ITLVAL", "DBD 64", 0},
                          {"DISV", "DBD 68", 0},
                          {"LMN", "DBD 72", 0},
                          {"LMN_PER", "DBW 76", 0},
                          {"QLMN_HLM", "DBX 78.0", 0},
                          {"QLMN_LLM", "DBX 78.1", 0},
                          {"LMN_P", "DBD 80", 0},
                          {"LMN_I", "DBD 84", 0},
                          {"LMN_D", "DBD 88", 0},
                          {"PV", "DBD 92", 0},
                          {"ER", "DBD 96", 0},
                          {"E_OLD", "DBD 100", 0},
                          {"I_OLD", "DBD 104", 0},
                          {"I_REST", "DBD 108", 0},
                          {"D_REST", "DBD 112", 0},
                          {"D_FEEDBACK", "DBD 116", 0},
                          {"LMN_LIMITED", "DBD 120", 0},
                          {"AT_HLM", "DBX 124.0", 0},
                          {"AT_LLM", "DBX 124.1", 0}};

// A controller in automatic mode with the setpoint 10.
Loop automatic(double setpoint = 10) {
  Loop loop(41);
  loop.set("MAN_ON", false);
  loop.set("SP_INT", setpoint);
  return loop;
}

std::vector<float> calls(Loop& loop, std::string_view name, int count) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i) {
    loop.call();
    values.push_back(loop.real(name));
  }
  return values;
}

void expectNear(const std::vector<float>& is, const std::vector<float>& should) {
  ASSERT_EQ(is.size(), should.size());
  for (std::size_t i = 0; i < is.size(); ++i)
    EXPECT_NEAR(is[i], should[i], 2e-5) << "call " << i + 1;
}

// PID-CONC-01, PID-CONC-02, PID-CONC-03, PID-CONC-04, PID-CONC-05, PID-CONC-06, PID-CONC-07,
// PID-CONC-08, PID-CONC-09, PID-CONC-10, PID-CONC-11, PID-CONC-12, PID-CONC-13, PID-CONC-14,
// PID-CONC-15, PID-CONC-16, PID-CONC-17, PID-CONC-18, PID-CONC-19, PID-CONC-20, PID-CONC-21,
// PID-CONC-22, PID-CONC-23, PID-CONC-24, PID-CONC-25
TEST(ContC, instanceDataBlock) {
  Loop loop(41);
  for (const Row& row : kTable) {
    EXPECT_EQ(loop.at(row.place), row.initial) << row.name;
    EXPECT_EQ(loop.plc().reference("DB41." + std::string(row.name)).operand,
              loop.plc().reference("DB41." + std::string(row.place)).operand)
        << row.name;
  }
  EXPECT_EQ(loop.plc()->program().at({BlockKind::DB, 41}).actualData.size(), 126u);
}

// PID-CONC-30, PID-CONC-31
TEST(ContC, processValueFromPeriphery) {
  Loop loop(41);
  loop.set("PVPER_ON", true);
  const struct {
    int periphery;
    float percent;
  } kRows[] = {{27648, 100}, {13824, 50}, {-27648, -100}, {32767, 118.5149F}, {1, 0.003616898F}};
  for (const auto& row : kRows) {
    loop.set("PV_PER", row.periphery);
    loop.call();
    EXPECT_FLOAT_EQ(loop.real("PV"), row.percent);
  }
  loop.set("PV_PER", 13824);
  loop.set("PV_FAC", 5.0);
  loop.set("PV_OFF", -50.0);
  loop.call();
  EXPECT_EQ(loop.real("PV"), 200);
  loop.set("PVPER_ON", false);  // PV_IN is not scaled (PID-CONC-03)
  loop.set("PV_IN", 7.5);
  loop.call();
  EXPECT_EQ(loop.real("PV"), 7.5F);
}

// PID-CONC-32
TEST(ContC, deadBand) {
  Loop loop(41);
  loop.set("DEADB_W", 2.0);
  const float kRows[][2] = {{1.5F, 0}, {2, 0}, {5, 3}, {-5, -3}, {-2, 0}};
  for (const auto& row : kRows) {
    loop.set("SP_INT", row[0]);
    loop.call();
    EXPECT_EQ(loop.real("ER"), row[1]) << row[0];
  }
}

// PID-CONC-34, PID-CONC-35, PID-CONC-11, PID-CONC-04; each call looks at BIE: PID-CONC-48
TEST(ContC, proportional) {
  Loop loop = automatic();
  loop.set("I_SEL", false);
  loop.call();
  EXPECT_EQ(loop.real("LMN"), 20);
  EXPECT_EQ(loop.word("LMN_PER"), 5530);
  loop.set("GAIN", -2.0);
  loop.call();
  EXPECT_EQ(loop.real("LMN_P"), -20);
}

// PID-CONC-36, PID-OP-10
TEST(ContC, integralByTrapezoids) {
  Loop loop = automatic();
  expectNear(calls(loop, "LMN", 6), {20.5F, 21.5F, 22.5F, 23.5F, 24.5F, 25.5F});
}

// PID-CONC-36: increments far below the last digit of the sum are not lost.
TEST(ContC, integralKeepsItsRest) {
  Loop loop = automatic(0.001);
  loop.set("P_SEL", false);
  loop.set("TI", 20'000'000);
  loop.set("I_ITLVAL", 50.0);
  loop.set("COM_RST", true);
  loop.call();
  loop.set("COM_RST", false);
  for (int i = 0; i < 20'000; ++i) loop.call();
  EXPECT_NEAR(loop.real("LMN_I"), 50 + 20'000 * 1e-7, 5e-6);
}

// PID-CONC-33, PID-CONC-26, PID-USE-14
TEST(ContC, timesHaveLowerBounds) {
  Loop zero = automatic(), half = automatic();
  zero.set("TI", 0);
  half.set("TI", 500);
  EXPECT_EQ(calls(zero, "LMN", 3), calls(half, "LMN", 3));
  EXPECT_EQ(zero.raw("TI"), 0u);
  Loop negative = automatic();
  negative.set("TI", -1);
  Loop same = automatic();
  same.set("TI", 500);
  EXPECT_EQ(calls(negative, "LMN", 3), calls(same, "LMN", 3));
}

// PID-CONC-33: TD >= CYCLE, TM_LAG >= CYCLE / 2.
TEST(ContC, timesOfTheDerivativeHaveLowerBounds) {
  const auto derivative = [](std::string_view name, int time) {
    Loop loop = automatic();
    loop.set("D_SEL", true);
    loop.set(name, time);
    return calls(loop, "LMN_D", 4);
  };
  for (const auto& [name, least] : {std::pair("TD", 1000), std::pair("TM_LAG", 500)}) {
    for (const int t : {0, least - 1}) EXPECT_EQ(derivative(name, t), derivative(name, least));
    EXPECT_NE(derivative(name, least + 1), derivative(name, least));
  }
}

// PID-CONC-37
TEST(ContC, derivativeWithLag) {
  Loop loop = automatic();
  loop.set("D_SEL", true);
  const float kD[] = {80, 48, 28.8F, 17.28F, 10.368F, 6.2208F};
  const float kLmn[] = {100, 68.5F, 50.3F, 39.78F, 33.868F, 30.7208F};
  const int kPeriphery[] = {27648, 18939, 13907, 10998, 9364, 8494};
  for (int i = 0; i < 6; ++i) {
    loop.call();
    EXPECT_NEAR(loop.real("LMN_D"), kD[i], 2e-5);
    EXPECT_NEAR(loop.real("LMN"), kLmn[i], 2e-5);
    EXPECT_EQ(loop.word("LMN_PER"), kPeriphery[i]);
    EXPECT_EQ(loop.flag("QLMN_HLM"), i == 0);
  }
}

// PID-CONC-38
TEST(ContC, disturbanceIsAdded) {
  Loop loop = automatic();
  loop.set("DISV", 5.0);
  expectNear(calls(loop, "LMN", 2), {25.5F, 26.5F});
}

// PID-CONC-39, PID-CONC-02, PID-OP-09
TEST(ContC, automaticBeginsBumpless) {
  Loop loop(41);
  loop.set("SP_INT", 10.0);
  loop.set("MAN", 37.5);
  expectNear(calls(loop, "LMN_I", 2), {-20, 17.5F});
  EXPECT_EQ(loop.real("LMN"), 37.5F);
  loop.set("MAN_ON", false);
  expectNear(calls(loop, "LMN", 3), {38.5F, 39.5F, 40.5F});
}

TEST(ContC, bumplessWithDisturbance) {  // PID-CONC-39
  Loop loop(41);
  loop.set("SP_INT", 10.0);
  loop.set("MAN", 37.5);
  loop.set("DISV", 5.0);
  expectNear(calls(loop, "LMN_I", 2), {-25, 12.5F});
  loop.set("MAN_ON", false);
  expectNear(calls(loop, "LMN", 1), {38.5F});
}

// PID-CONC-40
TEST(ContC, manualJumpsToItsValue) {
  Loop loop = automatic();
  loop.set("MAN", 37.5);
  EXPECT_EQ(calls(loop, "LMN", 5).back(), 24.5F);
  loop.set("MAN_ON", true);
  expectNear(calls(loop, "LMN", 1), {37.5F});
}

// PID-CONC-41, PID-CONC-42
TEST(ContC, limitsAndWindUp) {
  Loop loop = automatic(20);
  loop.set("LMN_HLM", 45.0);
  expectNear(calls(loop, "LMN", 2), {41, 43});
  EXPECT_FALSE(loop.flag("QLMN_HLM"));
  for (int i = 0; i < 10; ++i) {
    loop.call();
    EXPECT_EQ(loop.real("LMN"), 45);
    EXPECT_NEAR(loop.real("LMN_I"), 5, 2e-5);
    EXPECT_TRUE(loop.flag("QLMN_HLM"));
  }
  loop.set("SP_INT", -5.0);
  loop.call();
  EXPECT_EQ(loop.real("LMN"), 0);
  EXPECT_TRUE(loop.flag("QLMN_LLM"));
  EXPECT_FALSE(loop.flag("QLMN_HLM"));
}

// PID-CONC-41: limits are inclusive, the high one goes before.
TEST(ContC, limitsAreInclusive) {
  Loop loop = automatic(0);
  loop.set("I_SEL", false);
  loop.set("GAIN", 1.0);
  loop.set("LMN_HLM", 60.0), loop.set("LMN_LLM", 20.0);
  for (const double value : {19.5, 20.0, 20.5, 59.5, 60.0, 60.5}) {
    loop.set("SP_INT", value);
    loop.call();
    EXPECT_EQ(loop.flag("QLMN_HLM"), value >= 60) << value;
    EXPECT_EQ(loop.flag("QLMN_LLM"), value <= 20) << value;
  }
  loop.set("LMN_HLM", 20.0);
  loop.set("SP_INT", 20.0);
  loop.call();
  EXPECT_TRUE(loop.flag("QLMN_HLM") && !loop.flag("QLMN_LLM"));
}

// PID-CONC-42: an integral that stands beyond a limit which has come down returns to it.
TEST(ContC, integralReturnsToALowerLimit) {
  Loop loop = automatic(0);
  loop.set("I_ITLVAL", 80.0);
  loop.set("I_ITL_ON", true);
  loop.call();
  loop.set("I_ITL_ON", false);
  loop.set("LMN_HLM", 30.0);
  expectNear(calls(loop, "LMN_I", 1), {30});
  EXPECT_EQ(loop.real("LMN"), 30);
}

// PID-CONC-43, PID-CONC-19
TEST(ContC, normalisedOutput) {
  Loop loop(41);
  loop.set("LMN_HLM", 200.0);
  loop.set("LMN_LLM", -200.0);
  const struct {
    double manual;
    int periphery;
  } kRows[] = {{100, 27648}, {50, 13824}, {-100, -27648}, {120, 32511}, {-120, -32512}};
  for (const auto& row : kRows) {
    loop.set("MAN", row.manual);
    loop.call();
    EXPECT_EQ(loop.word("LMN_PER"), row.periphery) << row.manual;
  }
  loop.set("MAN", 50.0);
  loop.set("LMN_FAC", 0.5);
  loop.set("LMN_OFF", 10.0);
  loop.call();
  EXPECT_EQ(loop.real("LMN"), 35);
  EXPECT_EQ(loop.word("LMN_PER"), 9677);
}

// PID-CONC-44, PID-CONC-05
TEST(ContC, heldIntegral) {
  Loop loop = automatic();
  calls(loop, "LMN", 2);
  loop.set("INT_HOLD", true);
  expectNear(calls(loop, "LMN", 1), {21.5F});
  loop.set("INT_HOLD", false);
  expectNear(calls(loop, "LMN", 1), {22.5F});
}

// PID-CONC-45
TEST(ContC, integralIsSet) {
  Loop loop = automatic();
  loop.set("I_ITLVAL", 30.0);
  loop.set("I_ITL_ON", true);
  loop.set("INT_HOLD", true);
  expectNear(calls(loop, "LMN", 2), {50, 50});
  loop.set("I_ITL_ON", false);
  loop.set("INT_HOLD", false);
  expectNear(calls(loop, "LMN", 2), {51, 52});
}

// PID-CONC-46
TEST(ContC, partsAreSwitchedOnWithoutAKick) {
  Loop loop = automatic();
  calls(loop, "LMN", 2);
  loop.set("D_SEL", true);
  expectNear(calls(loop, "LMN_D", 1), {0});
  loop.set("I_SEL", false);
  expectNear(calls(loop, "LMN", 1), {20});
  EXPECT_EQ(loop.real("LMN_I"), 0);
}

// PID-CONC-47, PID-CONC-20
TEST(ContC, restart) {
  Loop loop = automatic();
  calls(loop, "LMN", 3);
  loop.set("I_ITLVAL", 25.0);
  loop.set("COM_RST", true);
  loop.call();
  for (const std::string_view name : {"LMN", "LMN_PER", "LMN_P", "LMN_I", "LMN_D", "PV", "ER"})
    EXPECT_EQ(loop.raw(name), 0u) << name;
  EXPECT_TRUE(loop.flag("COM_RST"));
  loop.set("COM_RST", false);
  expectNear(calls(loop, "LMN", 2), {45.5F, 46.5F});
}

// PID-CONC-49, PID-OP-08: never a fault of the CPU.
TEST(ContC, numbersThatAreNone) {
  Loop loop = automatic();
  loop.set("PV_IN", std::numeric_limits<float>::quiet_NaN());
  loop.call();
  EXPECT_TRUE(std::isnan(loop.real("LMN")));
  EXPECT_EQ(loop.word("LMN_PER"), 0);
  loop.set("I_SEL", false);
  loop.set("LMN_HLM", std::numeric_limits<float>::infinity());
  loop.set("PV_IN", -std::numeric_limits<float>::infinity());
  loop.call();
  EXPECT_EQ(loop.word("LMN_PER"), 32511);
  EXPECT_EQ(loop.plc()->mode(), Mode::Run);
}

TEST(ContC, withoutSampleTimeNothingHappens) {  // PID-OP-08
  Loop loop = automatic();
  loop.set("CYCLE", 0);
  loop.call();
  EXPECT_EQ(loop.real("LMN"), 0);
}

// PID-USE-15, PID-USE-16: by number and offset as by name.
TEST(ContC, resultsByAddress) {
  Loop loop = automatic();
  loop.call();
  EXPECT_EQ(loop.at("DBD 72"), bits(20.5F));
}

}  // namespace
}  // namespace merker::station::test
