// [[module.channel]] of the sub-module 2.4: defaults, and each wrong parameter is one problem with
// its place (technology manual 5.3).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

struct Read {
  std::string problem;  // "line:column code", the first one
  std::string words;
  std::size_t problems = 0;
  io::Parameters parameters;
};

Read read(std::string_view channel, std::string_view model = "314C-2 PtP") {
  // The channel's keys begin in line 7.
  const std::string text = fmt::format(
      "[cpu]\nmodel = \"{}\"\n[[module]]\nslot = \"2.4\"\n[[module.channel]]\nnumber = 0\n{}",
      model, channel);
  Problems problems;
  const Settings settings = readSettings(source::SourceFile("merker.toml", text), problems);
  Read result;
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
  const Read result = read(channel);
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
  EXPECT_EQ(good("").mode, io::CountMode::None);
}

// CNT-PARAM-20, CNT-PARAM-22, CNT-PARAM-23, CNT-PARAM-24, CNT-PARAM-26, CNT-PARAM-27
TEST(CountingSettings, DefaultsOfFrequencyAndPulseWidth) {
  const io::CountChannel f = good("mode = \"frequency\"\n");
  EXPECT_EQ(f.integrationTime, 100);
  EXPECT_EQ(f.highLimit, 60'000'000);
  EXPECT_FALSE(f.averaged);
  EXPECT_EQ(f.limitOutput, io::LimitOutput::None);
  // CNT-PARAM-29, CNT-PARAM-30, CNT-PARAM-31, CNT-PARAM-32, CNT-PARAM-34
  const io::CountChannel p = good("mode = \"pwm\"\n");
  EXPECT_EQ(p.period, 20'000);
  EXPECT_EQ(p.minimumPulse, 2);
  EXPECT_EQ(p.onDelay, 0);
  EXPECT_FALSE(p.analogFormat || p.milliseconds);
}

// CNT-PARAM-06, CNT-OP-12
TEST(CountingSettings, BackwardProposesOne) {
  EXPECT_EQ(good("mode = \"once\"\nmain_direction = \"backward\"\n").comparison, 1);
}

// CNT-PARAM-02, CNT-PARAM-18, CNT-PARAM-28
TEST(CountingSettings, InterruptsAreNamed) {
  const io::CountChannel c =
      good("mode = \"endless\"\ninterrupts = [\"overflow\", \"comparator\"]\n");
  EXPECT_TRUE(c.onOverflow && c.onComparator);
  EXPECT_FALSE(c.onUnderflow || c.onCountEdge);
  EXPECT_TRUE(good("mode = \"frequency\"\ninterrupts = [\"end of measurement\"]\n").onMeasured);
  EXPECT_FALSE(read("mode = \"endless\"\n").parameters.hardwareInterrupt);
}

struct Wrong {
  std::string_view text, problem, words;
};

// CNT-PARAM-03, CNT-PARAM-04, CNT-PARAM-06, CNT-PARAM-07, CNT-PARAM-15, CNT-PARAM-16,
// CNT-PARAM-17, CNT-PARAM-19, CNT-PARAM-20, CNT-PARAM-21, CNT-PARAM-22, CNT-PARAM-25,
// CNT-PARAM-32, CNT-PARAM-33, CNT-PARAM-35, CNT-PARAM-36, CNT-OP-14
TEST(CountingSettings, WrongOnesSayWhereAndWhatWouldBeRight) {
  const Wrong rows[] = {
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
      {"mode = \"pwm\"\nhysteresis = 1\n", "8:1 P0703", "on_delay"}};
  for (const Wrong& row : rows) {
    const Read result = read(row.text);
    EXPECT_EQ(result.problem, row.problem) << row.text << result.words;
    EXPECT_NE(result.words.find(row.words), std::string::npos) << result.words;
  }
}

// CNT-PARAM-08, CNT-PARAM-21, CNT-PARAM-34, CNT-OVW-01
TEST(CountingSettings, LimitsOfTheModel) {
  EXPECT_EQ(read("mode = \"endless\"\nmax_frequency = \"30kHz\"\n", "312C").problem, "8:17 P0737");
  EXPECT_EQ(read("mode = \"frequency\"\nhigh_limit = 30000001\n", "313C").problem, "8:14 P0704");
  EXPECT_EQ(read("mode = \"endless\"\n[[module.channel]]\nnumber = 2\n", "312C").problem,
            "9:10 P0738");
  EXPECT_EQ(read("[[module.channel]]\nnumber = 0\n").problem, "8:10 P0745");
}

}  // namespace
}  // namespace merker::project
