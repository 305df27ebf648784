// [[module.channel]] of the sub-module 2.4: defaults, and each wrong parameter is one problem with
// its place (technology manual 5.3).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

struct ChannelRead {
  std::string problem;  // "line:column code", the first one
  std::string words;
  std::size_t problems = 0;
  io::Parameters parameters;
};

ChannelRead readChannel(std::string_view channel, std::string_view model = "314C-2 PtP",
                        std::string_view selection = "process") {
  // The channel's keys begin in line 7.
  const std::string text = fmt::format(
      "cpu.model = \"{}\"\n[[module]]\nslot = \"2.4\"\ninterrupts = \"{}\"\n"
      "[[module.channel]]\nnumber = 0\n{}",
      model, selection, channel);
  Problems problems;
  const Settings settings = readSettings(source::SourceFile("merker.toml", text), problems);
  ChannelRead result;
  result.problems = problems.size();
  if (!problems.empty()) {
    const Problem& first = problems.list()[0];
    result.problem =
        fmt::format("{}:{} {}", first.position.line, first.position.column, first.name());
    result.words = first.message;
  }
  if (settings.hardware)
    if (const io::Module* module = settings.hardware->find("2.4"))
      result.parameters = module->parameters;
  return result;
}

io::CountChannel good(std::string_view channel) {
  const ChannelRead result = readChannel(channel);
  EXPECT_EQ(result.problems, 0u) << channel << ": " << result.words;
  return result.parameters.counters[0];
}

// CNT-OVW-02, CNT-PARAM-05, CNT-PARAM-07, CNT-PARAM-09, CNT-PARAM-11, CNT-PARAM-12, CNT-PARAM-14
TEST(CountingSettings, DefaultsOfCounting) {
  const io::CountChannel c = good("mode = \"endless\"\n");
  EXPECT_EQ(c.maxFrequency, 60u);
  EXPECT_EQ(c.latchFrequency, 10u);
  EXPECT_EQ(c.evaluation, io::Evaluation::PulseDirection);
  EXPECT_EQ(c.output, io::CountOutput::None);
  EXPECT_FALSE(c.hardwareGate || c.inverted || c.interruptGate || c.showPeriod || c.microseconds);
  EXPECT_EQ(c.hysteresis, 0);
  EXPECT_EQ(c.comparison, 0);
  EXPECT_EQ(c.pulseDuration, 0);
  EXPECT_EQ(c.direction, io::CountDirection::None);
  EXPECT_EQ(good("mode = \"once\"\nmain_direction = \"forward\"\n").endValue, 2'147'483'647);
  EXPECT_FALSE(c.onGateOpened || c.onGateClosed || c.onComparator || c.onOverflow ||
               c.onUnderflow || c.onCountEdge);
  EXPECT_EQ(good("").mode, io::CountMode::None);
}

// CNT-PARAM-20, CNT-PARAM-22, CNT-PARAM-23, CNT-PARAM-24, CNT-PARAM-26, CNT-PARAM-27
TEST(CountingSettings, DefaultsOfFrequencyAndPulseWidth) {
  const io::CountChannel f = good("mode = \"frequency\"\n");
  EXPECT_EQ(f.integrationTime, 100);
  EXPECT_EQ(f.highLimit, 60'000'000);
  EXPECT_FALSE(f.averaged);
  EXPECT_EQ(f.limitOutput, io::LimitOutput::None);
  EXPECT_EQ(f.maxFrequency, 60u);
  EXPECT_EQ(f.lowLimit, 0);
  EXPECT_EQ(f.evaluation, io::Evaluation::PulseDirection);
  EXPECT_FALSE(f.hardwareGate || f.inverted || f.onGateOpened || f.onGateClosed || f.onMeasured ||
               f.onLowLimit || f.onHighLimit);
  // CNT-PARAM-29, CNT-PARAM-30, CNT-PARAM-31, CNT-PARAM-32, CNT-PARAM-34
  const io::CountChannel p = good("mode = \"pwm\"\n");
  EXPECT_EQ(p.period, 20'000);
  EXPECT_EQ(p.minimumPulse, 2);
  EXPECT_EQ(p.onDelay, 0);
  EXPECT_EQ(p.maxFrequency, 60u);
  EXPECT_FALSE(p.analogFormat || p.milliseconds || p.hardwareGate || p.onGateOpened);
}

// CNT-PARAM-06, CNT-OP-12
TEST(CountingSettings, BackwardProposesOne) {
  EXPECT_EQ(good("mode = \"once\"\nmain_direction = \"backward\"\n").comparison, 1);
}

// CNT-PARAM-02, CNT-PARAM-18, CNT-PARAM-28, CNT-PARAM-35
TEST(CountingSettings, InterruptsAreNamed) {
  using io::CountChannel;
  struct Row {
    std::string_view mode, cause;
    bool CountChannel::*flag;
  };
  const Row rows[] = {{"endless", "gate opened", &CountChannel::onGateOpened},
                      {"endless", "gate closed", &CountChannel::onGateClosed},
                      {"endless", "comparator", &CountChannel::onComparator},
                      {"endless", "overflow", &CountChannel::onOverflow},
                      {"endless", "underflow", &CountChannel::onUnderflow},
                      {"endless", "count edge", &CountChannel::onCountEdge},
                      {"frequency", "gate opened", &CountChannel::onGateOpened},
                      {"frequency", "gate closed", &CountChannel::onGateClosed},
                      {"frequency", "end of measurement", &CountChannel::onMeasured},
                      {"frequency", "low limit", &CountChannel::onLowLimit},
                      {"frequency", "high limit", &CountChannel::onHighLimit},
                      {"pwm", "gate opened", &CountChannel::onGateOpened}};
  for (const Row& row : rows) {
    const CountChannel c = good(fmt::format(
        "mode = \"{}\"\nmax_frequency = \"1kHz\"\nhardware_gate = true\n{}interrupts = [\"{}\"]\n",
        row.mode, row.mode == "endless" ? "output = \">=\"\n" : "", row.cause));
    int set = 0;
    for (const Row& other : rows) set += other.mode == row.mode && c.*other.flag ? 1 : 0;
    EXPECT_TRUE(c.*row.flag) << row.cause;
    EXPECT_EQ(set, 1) << row.cause;
  }
  const io::Parameters none = readChannel("mode = \"endless\"\n", "314C-2 PtP", "none").parameters;
  EXPECT_FALSE(none.hardwareInterrupt);
  EXPECT_FALSE(none.diagnosticInterrupt);
}

// What is selected and can never come is a warning.
TEST(CountingSettings, InterruptsThatNeverCome) {
  const auto words = [](std::string_view channel, std::string_view selection = "process") {
    const ChannelRead result = readChannel(channel, "314C-2 PtP", selection);
    return result.problem + ' ' + result.words;
  };
  EXPECT_NE(words("mode = \"endless\"\ninterrupts = [\"gate opened\"]\n").find("hardware_gate"),
            std::string::npos);
  // The comparator compares without an output, too (CNT-CMP: 5.5.10, 5.5.12).
  EXPECT_EQ(words("mode = \"endless\"\ninterrupts = [\"comparator\"]\n"), " ");
  EXPECT_TRUE(words("mode = \"endless\"\ninterrupts = [\"overflow\"]\n", "diagnostics")
                  .starts_with("8:1 P0768"));
}

// The least and the greatest value of each parameter. CNT-PARAM-04, CNT-PARAM-06, CNT-PARAM-07,
// CNT-PARAM-15, CNT-PARAM-17, CNT-PARAM-20, CNT-PARAM-21, CNT-PARAM-22, CNT-PARAM-31,
// CNT-PARAM-32, CNT-PARAM-33
TEST(CountingSettings, BordersAreAccepted) {
  for (const std::string_view text :
       {"mode = \"once\"\nmain_direction = \"forward\"\nend_value = 2\ncomparison_value = 1\n",
        "mode = \"once\"\nmain_direction = \"forward\"\nend_value = 100\ncomparison_value = 99\n",
        "mode = \"periodic\"\nmain_direction = \"forward\"\ncomparison_value = -2147483648\n",
        "mode = \"once\"\nmain_direction = \"backward\"\nstart_value = "
        "2147483647\ncomparison_value = "
        "2147483647\n",
        "mode = \"endless\"\ncomparison_value = -2147483648\n",
        "mode = \"endless\"\ncomparison_value = 2147483647\nhysteresis = 255\npulse_duration = "
        "\"510ms\"\n",
        "mode = \"endless\"\nmax_frequency = \"1kHz\"\ninput_data = \"period\"\ntime_base = "
        "\"1us\"\n",
        "mode = \"frequency\"\nintegration_time = \"10ms\"\nlow_limit = 59999999\n",
        "mode = \"frequency\"\nintegration_time = \"10s\"\nlow_limit = 0\nhigh_limit = 1\n",
        "mode = \"pwm\"\nperiod = 4\non_delay = 65535\n",
        "mode = \"pwm\"\nperiod = 65535\nminimum_pulse = 32767\n",
        "mode = \"pwm\"\nperiod = 100\nminimum_pulse = 50\n",
        "mode = \"pwm\"\ntime_base = \"1ms\"\nperiod = 1\nminimum_pulse = 0\n"})
    good(text);
}

// CNT-PARAM-02
TEST(CountingSettings, InterruptSelection) {
  const auto selection = [](std::string_view slot, std::string_view word) {
    Problems problems;
    const auto text = fmt::format("[[module]]\nslot = \"{}\"\ninterrupts = \"{}\"\n", slot, word);
    const Settings settings = readSettings(source::SourceFile("merker.toml", text), problems);
    if (!problems.empty())
      return fmt::format("{} {}", problems.list()[0].position.line, problems.list()[0].name());
    const io::Parameters& p = settings.hardware->find(slot)->parameters;
    return fmt::format("{}{}", p.diagnosticInterrupt ? "D" : "", p.hardwareInterrupt ? "P" : "");
  };
  EXPECT_EQ(selection("2.4", "none"), "");
  EXPECT_EQ(selection("2.4", "diagnostics"), "D");
  EXPECT_EQ(selection("2.4", "process"), "P");
  EXPECT_EQ(selection("2.4", "diagnostics and process"), "DP");
  EXPECT_EQ(selection("2.4", "all"), "3 P0704");
  EXPECT_EQ(selection("2.2", "process"), "3 P0735");
}

struct WrongChannel {
  std::string_view text, problem, words;
};

// CNT-PARAM-03, CNT-PARAM-04, CNT-PARAM-06, CNT-PARAM-07, CNT-PARAM-15, CNT-PARAM-16,
// CNT-PARAM-17, CNT-PARAM-19, CNT-PARAM-20, CNT-PARAM-21, CNT-PARAM-22, CNT-PARAM-25,
// CNT-PARAM-32, CNT-PARAM-33, CNT-PARAM-35, CNT-PARAM-36, CNT-OP-14
TEST(CountingSettings, WrongOnesSayWhereAndWhatWouldBeRight) {
  const WrongChannel rows[] = {
      {"mode = \"endless\"\nmain_direction = \"forward\"\n", "8:1 P0744", "periodic"},
      {"mode = \"once\"\nend_value = 10\n", "8:1 P0744", "forward"},
      {"mode = \"once\"\nmain_direction = \"forward\"\nend_value = 1\n", "9:13 P0704", "2"},
      {"mode = \"once\"\nmain_direction = \"forward\"\nend_value = 100\ncomparison_value = 100\n",
       "10:20 P0704", "99"},
      {"mode = \"once\"\nmain_direction = \"backward\"\ncomparison_value = 0\n", "9:20 P0704", "1"},
      {"mode = \"endless\"\nhysteresis = 256\n", "8:14 P0704", "255"},
      {"mode = \"endless\"\npulse_duration = \"3ms\"\n", "8:18 P0704", "even"},
      {"mode = \"endless\"\nmax_frequency = \"20kHz\"\n", "8:17 P0737", "60kHz, 30kHz"},
      {"mode = \"endless\"\nmax_frequency = \"2kHz\"\ninput_data = \"period\"\n", "9:1 P0744",
       "1kHz"},
      {"mode = \"endless\"\ninterrupts = [\"count edge\"]\n", "8:1 P0744", "1kHz"},
      {"mode = \"endless\"\ninterrupts = [\"low limit\"]\n", "8:15 P0737", "underflow"},
      {"mode = \"frequency\"\nintegration_time = \"9ms\"\n", "8:20 P0704", "10ms"},
      {"mode = \"frequency\"\nlow_limit = 5\nhigh_limit = 5\n", "8:13 P0704", "below"},
      {"mode = \"frequency\"\nhigh_limit = 60000001\n", "8:14 P0704", "60000000"},
      {"mode = \"frequency\"\nevaluation = \"double\"\n", "8:14 P0704", "single"},
      {"mode = \"pwm\"\nperiod = 3\n", "8:10 P0704", "4"},
      {"mode = \"pwm\"\nperiod = 100\nminimum_pulse = 51\n", "9:17 P0704", "50"},
      {"mode = \"pwm\"\ninterrupts = [\"gate closed\"]\n", "8:15 P0737", "gate opened"},
      {"mode = \"pwm\"\nhysteresis = 1\n", "8:1 P0703", "on_delay"},
      // the rest of the masks, one parameter after the other
      {"mode = \"counting\"\n", "7:8 P0704", "periodic"},
      {"mode = \"once\"\nmain_direction = \"up\"\n", "8:18 P0704", "backward"},
      {"mode = \"once\"\nmain_direction = \"backward\"\nstart_value = 1\n", "9:15 P0704", "2"},
      {"mode = \"once\"\nmain_direction = \"forward\"\nend_value = 2147483648\n", "9:13 P0704",
       "2147483647"},
      {"mode = \"once\"\nmain_direction = \"forward\"\nstart_value = 5\n", "9:1 P0744", "backward"},
      {"mode = \"endless\"\ngate = \"stop\"\n", "8:8 P0704", "cancel"},
      {"mode = \"endless\"\ncomparison_value = 2147483648\n", "8:20 P0704", "2147483647"},
      {"mode = \"endless\"\nhysteresis = -1\n", "8:14 P0704", "0"},
      {"mode = \"endless\"\nlatch_frequency = \"11kHz\"\n", "8:19 P0737", "10kHz"},
      {"mode = \"endless\"\nevaluation = \"triple\"\n", "8:14 P0704", "quadruple"},
      {"mode = \"endless\"\nhardware_gate = 1\n", "8:17 P0704", "true"},
      {"mode = \"endless\"\ninverted = \"yes\"\n", "8:12 P0704", "true"},
      {"mode = \"endless\"\noutput = \"=\"\n", "8:10 P0704", ">="},
      {"mode = \"endless\"\npulse_duration = \"512ms\"\n", "8:18 P0704", "510ms"},
      {"mode = \"endless\"\ninput_data = \"speed\"\n", "8:14 P0704", "period"},
      {"mode = \"endless\"\ntime_base = \"1ms\"\n", "8:13 P0704", "125ns"},
      {"mode = \"frequency\"\nintegration_time = \"10001ms\"\n", "8:20 P0704", "10s"},
      {"mode = \"frequency\"\nintegration_time = \"10.5ms\"\n", "8:20 P0704", "whole"},
      {"mode = \"frequency\"\nlow_limit = -1\n", "8:13 P0704", "0"},
      {"mode = \"frequency\"\nhigh_limit = 0\n", "8:14 P0704", "1"},
      {"mode = \"frequency\"\nmax_frequency = \"3kHz\"\n", "8:17 P0737", "2kHz"},
      {"mode = \"frequency\"\nvalue = \"mean\"\n", "8:9 P0704", "averaged"},
      {"mode = \"frequency\"\noutput = \">=\"\n", "8:10 P0704", "outside"},
      {"mode = \"frequency\"\ninterrupts = [\"overflow\"]\n", "8:15 P0737", "high limit"},
      {"mode = \"frequency\"\nhardware_gate = \"on\"\n", "8:17 P0704", "true"},
      {"mode = \"frequency\"\ninverted = 0\n", "8:12 P0704", "true"},
      {"mode = \"pwm\"\nformat = \"percent\"\n", "8:10 P0704", "per mille"},
      {"mode = \"pwm\"\ntime_base = \"10ms\"\n", "8:13 P0704", "0.1ms"},
      {"mode = \"pwm\"\non_delay = 65536\n", "8:12 P0704", "65535"},
      {"mode = \"pwm\"\nperiod = 65536\n", "8:10 P0704", "65535"},
      {"mode = \"pwm\"\ntime_base = \"1ms\"\nperiod = 0\n", "9:10 P0704", "1"},
      {"mode = \"pwm\"\nminimum_pulse = 1\n", "8:17 P0704", "2"},
      {"mode = \"pwm\"\nmax_frequency = \"100kHz\"\n", "8:17 P0737", "60kHz"},
      {"mode = \"pwm\"\nhardware_gate = 2\n", "8:17 P0704", "true"}};
  for (const WrongChannel& row : rows) {
    const ChannelRead result = readChannel(row.text);
    EXPECT_EQ(result.problem, row.problem) << row.text << result.words;
    EXPECT_NE(result.words.find(row.words), std::string::npos) << result.words;
  }
}

// CNT-PARAM-08, CNT-PARAM-21, CNT-PARAM-34, CNT-OVW-01
TEST(CountingSettings, LimitsOfTheModel) {
  EXPECT_EQ(readChannel("mode = \"endless\"\nmax_frequency = \"30kHz\"\n", "312C").problem,
            "8:17 P0737");
  EXPECT_EQ(readChannel("mode = \"frequency\"\nhigh_limit = 30000001\n", "313C").problem,
            "8:14 P0704");
  EXPECT_EQ(readChannel("mode = \"endless\"\n[[module.channel]]\nnumber = 2\n", "312C").problem,
            "9:10 P0738");
  EXPECT_EQ(readChannel("[[module.channel]]\nnumber = 0\n").problem, "8:10 P0745");
}

}  // namespace
}  // namespace merker::project
