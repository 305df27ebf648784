// Pulse width modulation: the edges of the worked examples (technology manual 5.7).
#include "technology/pulse_width.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace merker::technology {
namespace {

constexpr Instant at(std::int64_t ms) { return Instant{ms * 1'000'000}; }

// Period 20 ms at 0.1 ms.
io::CountChannel parameters() {
  io::CountChannel p;
  p.mode = io::CountMode::PulseWidth;
  p.period = 200;
  return p;
}

// Instants in ms at which the output changes, until `end`; `change` happens at `when`.
std::vector<double> edges(PulseWidth& pwm, std::int64_t end, std::int64_t when = -1,
                          const std::function<void()>& change = {}) {
  std::vector<double> list;
  bool level = false;
  const auto note = [&](Instant now) {
    if (pwm.output() != level) list.push_back(static_cast<double>(now.ns) / 1e6);
    level = pwm.output();
  };
  note({});
  for (bool done = false; pwm.due() <= at(end) || (!done && when >= 0);) {
    if (!done && when >= 0 && at(when) < pwm.due()) {
      change();
      done = true;
      note(at(when));
      continue;
    }
    const Instant now = pwm.due();
    pwm.expire(now);
    note(now);
  }
  return list;
}

PulseWidth running(const io::CountChannel& p, std::int32_t value) {
  PulseWidth pwm(p);
  pwm.start(false, {});
  pwm.control(true, false, false, value, {});
  return pwm;
}

using Edges = std::vector<double>;

// CNT-PWM-01, CNT-PWM-02
TEST(PulseWidthModulation, DelayThenPulses) {
  io::CountChannel p = parameters();
  p.onDelay = 50;
  PulseWidth pwm = running(p, 300);
  EXPECT_EQ(edges(pwm, 46), (Edges{5, 11, 25, 31, 45}));
}

// CNT-PWM-03, CNT-PWM-04, CNT-IF49-05
TEST(PulseWidthModulation, LengthOfThePulse) {
  io::CountChannel p = parameters();
  p.analogFormat = true;
  PulseWidth analog = running(p, 13'824);
  EXPECT_EQ(edges(analog, 21), (Edges{0, 10, 20}));
  p.analogFormat = false;
  p.minimumPulse = 10;
  struct Row {
    std::int32_t value;
    Edges edges;
  };
  for (const Row& row : {Row{49, {}}, Row{50, {0, 1, 20}}, Row{950, {0, 19, 20}}, Row{951, {0}},
                         Row{1500, {0}}, Row{-5, {}}}) {
    PulseWidth pwm = running(p, row.value);
    EXPECT_EQ(edges(pwm, 20), row.edges) << row.value;
  }
}

// CNT-PWM-05
TEST(PulseWidthModulation, TheShortestPeriod) {
  io::CountChannel p = parameters();
  p.period = 4;
  PulseWidth pwm = running(p, 500);
  EXPECT_EQ(edges(pwm, 1), (Edges{0, 0.2, 0.4, 0.6, 0.8, 1.0}));
  p.milliseconds = true;
  p.period = 1;
  p.minimumPulse = 0;
  PulseWidth slow = running(p, 199);
  EXPECT_EQ(edges(slow, 2), Edges{});
}

// CNT-PWM-06, CNT-PWM-07, CNT-PWM-08, CNT-PRAL-06
TEST(PulseWidthModulation, Gates) {
  PulseWidth soft = running(parameters(), 500);
  EXPECT_TRUE(soft.output());
  soft.control(false, false, false, 500, at(3));
  EXPECT_FALSE(soft.output() || soft.running());
  io::CountChannel p = parameters();
  p.hardwareGate = p.onGateOpened = true;
  PulseWidth hard(p);
  hard.start(true, {});
  hard.control(true, false, false, 500, {});
  EXPECT_FALSE(hard.running());
  hard.gateEdge(false, at(1));
  hard.gateEdge(true, at(2));
  EXPECT_TRUE(hard.running());
  EXPECT_EQ(hard.takeCauses(), io::kGateOpened);
  hard.gateEdge(false, at(3));
  EXPECT_TRUE(hard.running());
  hard.control(false, false, false, 500, at(4));
  EXPECT_FALSE(hard.running());
}

// CNT-PWM-09
TEST(PulseWidthModulation, ManualKeepsThePhase) {
  PulseWidth pwm = running(parameters(), 500);
  pwm.control(true, true, false, 500, {});
  EXPECT_FALSE(pwm.output());
  EXPECT_EQ(edges(pwm, 65), Edges{});
  pwm.control(true, false, false, 500, at(65));
  EXPECT_TRUE(pwm.output());
  EXPECT_EQ(pwm.due(), at(70));
}

// CNT-PWM-10
TEST(PulseWidthModulation, ANewValueWhileItRuns) {
  struct Row {
    std::int64_t when;
    std::int32_t value;
    std::int64_t end;
    Edges edges;
  };
  for (const Row& row : {Row{15, 250, 25, {0, 10, 25}}, Row{15, 750, 30, {0, 10, 15, 30}},
                         Row{8, 250, 23, {0, 8, 23}}, Row{8, 750, 20, {0, 15, 20}}}) {
    PulseWidth pwm = running(parameters(), 500);
    EXPECT_EQ(edges(pwm, row.end, row.when,
                    [&] { pwm.control(true, false, false, row.value, at(row.when)); }),
              row.edges);
  }
}

// CNT-PWM-11
TEST(PulseWidthModulation, ANewPeriodWhileItRuns) {
  struct Row {
    std::int64_t when;
    std::int32_t period;
    std::int64_t end;
    Edges edges;
  };
  for (const Row& row : {Row{12, 100, 15, {0, 10, 15}}, Row{12, 300, 25, {0, 10, 25}},
                         Row{8, 100, 13, {0, 8, 13}}, Row{8, 300, 30, {0, 15, 30}}}) {
    PulseWidth pwm = running(parameters(), 500);
    EXPECT_EQ(edges(pwm, row.end, row.when, [&] { pwm.job(1, row.period, at(row.when)); }),
              row.edges);
  }
}

// CNT-PWM-12, CNT-PWM-13
TEST(PulseWidthModulation, ANewDelayAndMinimumWhileItRuns) {
  io::CountChannel p = parameters();
  p.onDelay = 100;
  PulseWidth shorter = running(p, 500), longer = running(p, 500);
  EXPECT_EQ(edges(shorter, 6, 6, [&] { shorter.job(2, 40, at(6)); }), Edges{6});
  EXPECT_EQ(edges(longer, 20, 6, [&] { longer.job(2, 200, at(6)); }), Edges{20});
  PulseWidth minimum = running(parameters(), 200);
  EXPECT_EQ(edges(minimum, 60, 2, [&] { minimum.job(4, 50, at(2)); }), (Edges{0, 2}));
}

// CNT-PWM-07: an edge at the HW gate while the SW gate is closed starts nothing, not even later.
TEST(PulseWidthModulation, TheSoftwareGateComesFirst) {
  io::CountChannel p = parameters();
  p.hardwareGate = p.onGateOpened = true;
  PulseWidth pwm(p);
  pwm.start(false, {});
  pwm.control(false, false, false, 500, {});
  pwm.gateEdge(true, at(1));
  EXPECT_FALSE(pwm.running() || pwm.output());
  EXPECT_EQ(pwm.takeCauses(), 0u);
  pwm.control(true, false, false, 500, at(2));
  EXPECT_FALSE(pwm.running() || pwm.output());
  pwm.gateEdge(false, at(3));
  pwm.gateEdge(true, at(4));
  EXPECT_TRUE(pwm.running());
}

}  // namespace
}  // namespace merker::technology
