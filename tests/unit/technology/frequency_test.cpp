// Frequency measurement (technology manual 5.6).
#include "technology/frequency.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "signal/pulse_train.h"

namespace merker::technology {
namespace {

constexpr std::int32_t kHighest = 60'000'000;

io::CountChannel parameters(std::int32_t window, bool averaged = false) {
  io::CountChannel p;
  p.mode = io::CountMode::Frequency;
  p.integrationTime = window;
  p.averaged = averaged;
  p.highLimit = kHighest;
  return p;
}

// Feeds edges of a signal until `end`, windows in between.
void feed(Frequency& f, const signal::Signal& s, Instant& now, Instant end) {
  for (;;) {
    const Instant edge = s.next(now), next = std::min(edge, f.due());
    if (next > end) break;
    now = next;
    if (edge == next && s.level(now)) f.pulse(1, now);
    if (f.due() == next) f.expire(now);
  }
  now = end;
}

Frequency started(const io::CountChannel& p) {
  Frequency f(p, kHighest);
  f.start(false, {});
  f.control(true, false, false, {});
  return f;
}

// CNT-FREQ-01, CNT-FREQ-02, CNT-FREQ-05, CNT-IF48-03
TEST(FrequencyMeasurement, WholePeriodsByTimeStamps) {
  Frequency f = started(parameters(100));
  EXPECT_EQ(f.value(), -1);
  const signal::PulseTrain s(signal::pulsesOf(123'456, 500, Instant{1'000'000}));
  Instant now;
  for (int window = 1; window <= 20; ++window) {
    feed(f, s, now, Instant{100'000'000LL * window});
    EXPECT_NEAR(f.value(), 123'456, 1) << window;
    EXPECT_TRUE(f.measured());
    f.resetStatus();
  }
  EXPECT_EQ(f.count(), 247);
}

// CNT-FREQ-04, CNT-FREQ-06
TEST(FrequencyMeasurement, PermissibleErrors) {
  struct Row {
    std::int32_t window;
    std::int64_t millihertz, error;
  };
  const Row rows[] = {{10'000, 250, 1},
                      {10'000, 10'000'000, 2000},
                      {10'000, 30'000'000, 5000},
                      {10'000, 60'000'000, 10'000},
                      {1000, 2500, 1},
                      {1000, 10'000'000, 2000},
                      {1000, 30'000'000, 5000},
                      {1000, 60'000'000, 10'000},
                      {100, 25'000, 2},
                      {100, 10'000'000, 2000},
                      {100, 30'000'000, 5000},
                      {100, 60'000'000, 10'000},
                      {10, 250'000, 100},
                      {10, 10'000'000, 6000},
                      {10, 30'000'000, 10'000},
                      {10, 60'000'000, 20'000}};
  for (const Row& row : rows) {
    Frequency f = started(parameters(row.window));
    const signal::PulseTrain s(signal::pulsesOf(row.millihertz, 500, Instant{777}));
    Instant now;
    feed(f, s, now, Instant{2'000'000LL * row.window});
    EXPECT_LE(std::abs(f.value() - row.millihertz), row.error) << row.millihertz;
  }
}

// CNT-FREQ-07
TEST(FrequencyMeasurement, SlowSignalsAreZeroWhenDirect) {
  Frequency f = started(parameters(100));
  const signal::PulseTrain s(signal::pulsesOf(5000, 500, Instant{1'000'000}));
  Instant now;
  for (int window = 1; window <= 10; ++window) {
    feed(f, s, now, Instant{100'000'000LL * window});
    EXPECT_EQ(f.value(), 0);
  }
}

// CNT-FREQ-08, CNT-FREQ-09
TEST(FrequencyMeasurement, Averaged) {
  Frequency f = started(parameters(100, true));
  f.pulse(1, Instant{10'000'000});
  f.pulse(1, Instant{10'000'000 + 83'333'333});
  f.expire(Instant{100'000'000});
  EXPECT_EQ(f.value(), 12'000);
  for (const std::int32_t expected : {12'000, 6000, 4000, 3000, 2400}) {
    f.expire(f.due());
    EXPECT_EQ(f.value(), expected);
  }
  Frequency slow = started(parameters(100, true));
  slow.pulse(1, Instant{10'000'000});
  slow.pulse(1, Instant{360'000'000});
  slow.expire(Instant{400'000'000});
  EXPECT_EQ(slow.value(), 2857);
}

// CNT-FREQ-03
TEST(FrequencyMeasurement, ANewIntegrationTimeCountsFromTheNextWindow) {
  Frequency f = started(parameters(100));
  f.job(4, 500);
  EXPECT_EQ(f.due(), Instant{100'000'000});
  f.expire(f.due());
  EXPECT_EQ(f.due(), Instant{600'000'000});
}

// CNT-FREQ-11, CNT-FREQ-12, CNT-IF48-07
TEST(FrequencyMeasurement, GateAndCount) {
  Frequency f = started(parameters(100));
  EXPECT_FALSE(f.down());
  for (int i = 1; i <= 10; ++i) f.pulse(-1, Instant{i * 1'000'000});
  EXPECT_EQ(f.count(), -10);
  EXPECT_TRUE(f.down());
  f.expire(f.due());
  EXPECT_EQ(f.value(), 1'000'000);
  f.control(false, false, false, Instant{150'000'000});
  EXPECT_EQ(f.due(), Instant::never());
  EXPECT_EQ(f.value(), 1'000'000);
  f.control(true, false, false, Instant{200'000'000});
  EXPECT_EQ(f.value(), -1);
  EXPECT_EQ(f.count(), 0);
}

// CNT-FREQ-12: both gates open it, either closes it; CNT-FREQ-10: both directions count.
TEST(FrequencyMeasurement, HardwareGate) {
  io::CountChannel p = parameters(100);
  p.hardwareGate = true;
  Frequency f(p, kHighest);
  f.start(false, {});
  f.control(true, false, false, {});
  EXPECT_FALSE(f.gateOpen());
  f.gateEdge(true, Instant{10'000'000});
  EXPECT_EQ(f.due(), Instant{110'000'000});
  f.pulse(1, Instant{20'000'000});
  f.pulse(1, Instant{40'000'000});
  f.pulse(-1, Instant{60'000'000});
  EXPECT_TRUE(f.down());
  f.expire(f.due());
  EXPECT_EQ(f.value(), 50'000);
  EXPECT_EQ(f.count(), 1);
  f.gateEdge(false, Instant{150'000'000});
  EXPECT_EQ(f.due(), Instant::never());
  EXPECT_EQ(f.value(), 50'000);
  f.gateEdge(true, Instant{200'000'000});
  EXPECT_EQ(f.value(), -1);
  EXPECT_EQ(f.count(), 0);
}

// CNT-FREQ-13: strictly outside; MAN_DO and SET_DO go before.
TEST(FrequencyMeasurement, OutputsByTheLimits) {
  struct Row {
    io::LimitOutput output;
    bool low, between, high;
  };
  for (const Row& row : {Row{io::LimitOutput::Outside, true, false, true},
                         Row{io::LimitOutput::Below, true, false, false},
                         Row{io::LimitOutput::Above, false, false, true},
                         Row{io::LimitOutput::None, false, false, false}}) {
    const auto outputAt = [&](std::int64_t period) {
      io::CountChannel p = parameters(1000);
      p.lowLimit = 4000;
      p.highLimit = 5000;
      p.limitOutput = row.output;
      Frequency f = started(p);
      f.pulse(1, Instant{1});
      f.pulse(1, Instant{1 + period});
      f.expire(f.due());
      return f.output();
    };
    EXPECT_EQ(outputAt(251'000'000), row.low);
    EXPECT_EQ(outputAt(250'000'000), row.between);  // 4000 mHz
    EXPECT_EQ(outputAt(200'000'000), row.between);  // 5000 mHz
    EXPECT_EQ(outputAt(199'000'000), row.high);
  }
  io::CountChannel p = parameters(1000);
  p.limitOutput = io::LimitOutput::Above;
  Frequency f = started(p);
  f.control(true, true, true, {});
  EXPECT_TRUE(f.output());
  f.control(true, false, true, {});
  EXPECT_FALSE(f.output());
}

// CNT-FREQ-13, CNT-FREQ-14, CNT-FREQ-16, CNT-PRAL-10, CNT-IF48-06
TEST(FrequencyMeasurement, Limits) {
  io::CountChannel p = parameters(1000);
  p.lowLimit = 1000;
  p.highLimit = 2000;
  p.limitOutput = io::LimitOutput::Outside;
  p.onHighLimit = p.onMeasured = true;
  Frequency f = started(p);
  f.pulse(1, Instant{1});
  f.pulse(1, Instant{500'000'001});
  f.expire(f.due());
  EXPECT_EQ(f.value(), 2000);
  EXPECT_FALSE(f.output() || f.overflow());
  EXPECT_EQ(f.takeCauses(), io::kMeasured);
  f.pulse(1, Instant{999'000'000});
  f.expire(f.due());
  EXPECT_GT(f.value(), 2000);
  EXPECT_TRUE(f.output() && f.overflow());
  EXPECT_EQ(f.takeCauses(), io::kMeasured | io::kLimit);
  f.resetStatus();
  EXPECT_TRUE(f.overflow());
  f.control(true, true, false, Instant{2'000'000'000});
  EXPECT_FALSE(f.output());
  f.expire(f.due());
  EXPECT_EQ(f.value(), 0);
  EXPECT_TRUE(f.underflow());
  EXPECT_EQ(f.takeCauses(), io::kMeasured);
}

// CNT-FREQ-05: rounded, not cut.
TEST(FrequencyMeasurement, Rounds) {
  struct Row {
    std::int64_t period;
    std::int32_t value;
  };
  for (const Row& row : {Row{150'000'000, 6667}, Row{300'000'000, 3333}, Row{128'000'000, 7813},
                         Row{350'000'000, 2857}, Row{70'000'000, 14'286}}) {
    Frequency f = started(parameters(1000));
    f.pulse(1, Instant{1});
    f.pulse(1, Instant{1 + row.period});
    f.expire(f.due());
    EXPECT_EQ(f.value(), row.value) << row.period;
  }
}

// CNT-IF48-06: RES_STS resets all three; what holds no longer stays reset.
TEST(FrequencyMeasurement, ResetOfTheStatus) {
  io::CountChannel p = parameters(1000);
  p.lowLimit = 1000;
  p.highLimit = 2000;
  Frequency f = started(p);
  f.pulse(1, Instant{1});
  f.pulse(1, Instant{300'000'001});  // above
  f.expire(f.due());
  EXPECT_TRUE(f.overflow() && f.measured());
  f.pulse(1, Instant{1'000'000'001});  // 1.43 Hz: within
  f.expire(f.due());
  EXPECT_TRUE(f.overflow());
  f.resetStatus();
  EXPECT_FALSE(f.overflow() || f.underflow() || f.measured());
  f.expire(f.due());  // no pulse: 0, below
  EXPECT_TRUE(f.underflow());
  f.pulse(1, Instant{3'800'000'000});
  f.expire(f.due());
  f.pulse(1, Instant{4'500'000'000});  // 0.7 s later
  f.expire(f.due());
  EXPECT_TRUE(f.underflow());
  f.resetStatus();
  EXPECT_FALSE(f.overflow() || f.underflow());
}

}  // namespace
}  // namespace merker::technology
