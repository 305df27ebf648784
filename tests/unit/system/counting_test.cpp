// SFB 47 to 49 in a CPU: channels of the models, addresses, gates and calls (technology manual 5.4,
// 5.5.5, 5.8.2, 5.10).
#include <gtest/gtest.h>

#include "counting_plc.h"

namespace merker::station::test {
namespace {

// CNT-OVW-01, CNT-ERR-05
TEST(CountingBlocks, ChannelsOfTheModels) {
  struct Row {
    std::string_view model;
    std::uint32_t channels;
  };
  for (const Row& row : {Row{"312C", 2}, Row{"313C", 3}, Row{"313C-2 DP", 3}, Row{"313C-2 PtP", 3},
                         Row{"314C-2 DP", 4}, Row{"314C-2 PN/DP", 4}, Row{"314C-2 PtP", 4}}) {
    Counting c(
        47,
        [&](io::Parameters& p, io::Module&) {
          p.counters[row.channels - 1] = channel(CountMode::Endless);
        },
        "", *findCpuModel(row.model));
    c.set("LADDR", *c.plc->rack()->configuration().find("2.4")->inputStart);
    c.set("CHANNEL", row.channels - 1);
    EXPECT_EQ(c.status(), 0u) << row.model;
    c.set("CHANNEL", 0);  // not parametrised
    EXPECT_EQ(c.status(), 0x8001u) << row.model;
    c.set("CHANNEL", row.channels);
    EXPECT_EQ(c.status(), 0x8009u) << row.model;
    c.set("CHANNEL", 0xFFFF);
    EXPECT_EQ(c.status(), 0x8009u) << row.model;
  }
}

// CNT-PIO-07, CNT-ERR-06, CNT-PIO-02
TEST(CountingBlocks, AnotherAddress) {
  Counting c(47, [](io::Parameters& p, io::Module& module) {
    p.counters[1] = channel(CountMode::Endless);
    module.inputStart = module.outputStart = 800;
  });
  c.set("CHANNEL", 1);
  EXPECT_EQ(c.status(), 0x8001u);
  c.set("LADDR", 0x320);
  c.set("SW_GATE", 1);
  EXPECT_EQ(c.status(), 0u);
  c.pulses(3, 7);
  c.wait(100);
  EXPECT_EQ(c.plc.read("PED 804"), 7u);
  EXPECT_EQ(c.plc.read("PED 800"), 0u);
}

// CNT-GATE-01, CNT-GATE-02: the software gate takes effect with the call, the hardware gate at
// once.
TEST(CountingBlocks, GatesAndCalls) {
  Counting c(47, [](io::Parameters& p, io::Module&) {
    p.counters[0] = channel(CountMode::Endless);
    p.counters[0].hardwareGate = true;
  });
  c.input(2, true);
  c.wait(5);
  EXPECT_EQ(c.read("STS_STRT"), 1u);
  c.plc.write("M 100.0", 1);
  c.set("SW_GATE", 1);
  c.pulses(0, 3);
  c.wait(50);
  EXPECT_EQ(c.plc.read("PED 768"), 0u);
  c.plc.write("M 100.0", 0);
  c.wait(5);
  c.plc.write("M 100.0", 1);
  c.wait(5);
  c.input(2, false);
  c.wait(5);
  c.pulses(0, 3);
  c.wait(50);
  EXPECT_EQ(c.plc.read("PED 768"), 0u);
  EXPECT_EQ(c.read("STS_STRT"), 1u);  // nobody has called
  c.input(2, true);
  c.wait(5);
  c.pulses(0, 3);
  c.wait(50);
  EXPECT_EQ(c.plc.read("PED 768"), 3u);
  EXPECT_EQ(c.read("COUNTVAL"), 0u);
}

// CNT-IF47-11, CNT-JOB-02: reset of the status bits and end of a job, one call later.
TEST(CountingBlocks, OneCallLater) {
  Counting c(47,
             [](io::Parameters& p, io::Module&) { p.counters[0] = channel(CountMode::Endless); });
  EXPECT_EQ(c.read("STS_C_UP"), 1u);  // CNT-IF47-06
  EXPECT_EQ(c.read("STS_C_DN"), 0u);
  c.set("SW_GATE", 1);
  c.plc->advanceCycles(1);
  EXPECT_EQ(c.read("STS_ZP"), 1u);
  c.set("RES_STS", 1);
  c.plc->advanceCycles(1);
  EXPECT_EQ(c.read("STS_ZP"), 1u);
  c.plc->advanceCycles(1);
  EXPECT_EQ(c.read("STS_ZP"), 0u);
  c.set("JOB_ID", 1);
  c.set("JOB_VAL", 77);
  c.set("JOB_REQ", 1);
  c.plc->advanceCycles(1);
  EXPECT_EQ(c.read("JOB_DONE"), 0u);
  EXPECT_EQ(c.read("COUNTVAL"), 77u);
  c.set("JOB_VAL", 78);
  c.plc->advanceCycles(1);
  EXPECT_EQ(c.read("JOB_DONE"), 1u);
  EXPECT_EQ(c.read("COUNTVAL"), 77u);
}

// CNT-JOB-15: none with a system error.
TEST(CountingBlocks, NoJobWithASystemError) {
  Counting c(47,
             [](io::Parameters& p, io::Module&) { p.counters[0] = channel(CountMode::Endless); });
  c.set("JOB_ID", 1);
  c.set("JOB_VAL", 77);
  c.set("JOB_REQ", 1);
  c.set("LADDR", 0x301);
  EXPECT_EQ(c.status(), 0x8001u);
  c.set("JOB_REQ", 0);
  c.set("LADDR", 0x300);
  EXPECT_EQ(c.status(), 0u);
  EXPECT_EQ(c.read("COUNTVAL"), 0u);
}

// CNT-PIO-05: the value of the instant, in the middle of a cycle.
TEST(CountingBlocks, InputDataOfTheInstant) {
  Counting c(
      47,
      [](io::Parameters& p, io::Module&) {
        p.counters[0] = channel(CountMode::Endless);
        p.counters[0].maxFrequency = 60;
      },
      ob(35, "L PED 768; T MD 20; CALL SFC 47 (WT := 1000); L PED 768; T MD 24;"));
  c.set("SW_GATE", 1);
  c.pulses(0, 0, 60'000);
  c.wait(150);
  const std::uint32_t counted = c.plc.read("MD 24") - c.plc.read("MD 20");
  EXPECT_GE(counted, 60u);
  EXPECT_LE(counted, 61u);
}

// CNT-OP-24, CNT-PIN-10: inputs without a function do nothing.
TEST(CountingBlocks, InputsWithoutAFunction) {
  Counting pwm(49, [](io::Parameters& p, io::Module&) {
    p.counters[0] = channel(CountMode::PulseWidth);
    p.counters[0].period = 100;
  });
  pwm.input(0, true);
  pwm.input(1, true);
  pwm.input(12, true);
  pwm.set("SW_EN", 1);
  pwm.set("OUTP_VAL", 500);
  pwm.plc->advanceCycles(1);
  EXPECT_TRUE(pwm.output(0));
  pwm.wait(5);
  EXPECT_FALSE(pwm.output(0));
  Counting frequency(
      48, [](io::Parameters& p, io::Module&) { p.counters[0] = channel(CountMode::Frequency); });
  frequency.set("SW_GATE", 1);
  frequency.plc->advanceCycles(1);
  std::vector<std::uint32_t> words;
  for (int i = 10; i < 34; i += 2)
    words.push_back(frequency.plc.read("DB9.DBW " + std::to_string(i)));
  frequency.input(12, true);
  frequency.wait(5);
  for (int i = 10; i < 34; i += 2)
    EXPECT_EQ(frequency.plc.read("DB9.DBW " + std::to_string(i)), words[(i - 10) / 2]) << i;
}

// Both engines see the same channel at each end of a cycle, with jitter and at the highest
// frequency.
TEST(CountingBlocks, TheSameWithBothEngines) {
  const auto seen = [](Engine engine, std::uint32_t jitter) {
    Counting c(
        47,
        [](io::Parameters& p, io::Module&) {
          CountChannel& n = p.counters[0] = channel(CountMode::Periodic);
          n.maxFrequency = 60;
          n.direction = io::CountDirection::Forward;
          n.endValue = 1000;
          n.comparison = 300;
          n.hysteresis = 20;
          n.output = io::CountOutput::AtLeast;
          p.hardwareInterrupt = n.onOverflow = true;
        },
        ob(40, "L MW 10; + 1; T MW 10; L PED 768; T MD 12;"));
    std::vector<std::uint32_t> values;
    if (!c.plc->setEngine(engine)) return values;
    c.set("SW_GATE", 1);
    c.set("CTRL_DO", 1);
    signal::Pulses p = signal::pulsesOf(50'000'000, 500, c.plc->now());
    p.jitter = jitter;
    c.plc->rack()->attach(*c.plc->rack()->terminal("2.2", io::Side::DigitalInput, 0),
                          std::make_shared<signal::PulseTrain>(p), c.plc->now());
    for (int i = 0; i < 500; ++i) {
      c.plc->advanceCycles(1);
      for (const char* name : {"DBB 12", "DBD 14", "DBB 26"}) values.push_back(c.read(name));
      for (const char* name : {"MW 10", "MD 12"}) values.push_back(c.plc.read(name));
    }
    return values;
  };
  for (const std::uint32_t jitter : {0u, 50u}) {
    const auto compiled = seen(Engine::Compiled, jitter);
    if (compiled.empty()) GTEST_SKIP() << "no compiler for this processor";
    const auto interpreted = seen(Engine::Interpreter, jitter);
    EXPECT_EQ(interpreted, compiled);
    EXPECT_GT(interpreted[interpreted.size() - 2], 0u);  // OB 40 ran
  }
}

}  // namespace
}  // namespace merker::station::test
