// Inputs, filters and evaluation of a channel; over whole periods in one step, and the same count
// as edge by edge.
#include "technology/channel.h"

#include <gtest/gtest.h>

#include "signal/encoder.h"
#include "signal/pulse_train.h"
#include "technology/counter.h"

namespace merker::technology {
namespace {

using io::Evaluation;
using signal::EncoderTrack;
using signal::Motion;
using signal::Track;

io::CountChannel parameters(Evaluation evaluation, std::uint32_t kilohertz = 60) {
  io::CountChannel p;
  p.mode = io::CountMode::Endless;
  p.evaluation = evaluation;
  p.maxFrequency = kilohertz;
  p.latchFrequency = 10;
  return p;
}

class Wired {
 public:
  explicit Wired(const io::CountChannel& p) : channel(p, 60) {
    channel.start({});
    counter().control(true, true, false, {});
  }
  Counter& counter() { return dynamic_cast<Counter&>(*channel.function()); }
  void encoder(const Motion& motion) {
    const EncoderTrack a(motion, Track::A), b(motion, Track::B);
    channel.advance(motion.start);
    channel.set(Channel::TrackB, b.level(motion.start), std::make_shared<EncoderTrack>(b),
                motion.start);
    channel.set(Channel::TrackA, a.level(motion.start), std::make_shared<EncoderTrack>(a),
                motion.start);
  }
  void pulses(const signal::Pulses& p) {
    channel.advance(p.start);
    channel.set(Channel::TrackA, true, std::make_shared<signal::PulseTrain>(p), p.start);
  }
  std::int32_t countAt(Instant now) {
    channel.advance(now);
    return counter().count();
  }
  Channel channel;
};

constexpr Instant kSecond{1'000'000'000}, kTwoSeconds{2'000'000'000};

// CNT-OVW-05, CNT-ENC-04, CNT-PARAM-13
TEST(ChannelInputs, PulsesAndDirection) {
  for (const bool inverted : {false, true}) {
    io::CountChannel p = parameters(Evaluation::PulseDirection);
    p.inverted = inverted;
    Wired w(p);
    signal::Pulses train = signal::pulsesOf(60'000'000, 500, Instant{0});
    train.count = 60'000;
    w.pulses(train);
    EXPECT_EQ(w.countAt(kTwoSeconds), inverted ? -60'000 : 60'000);
  }
}

// CNT-OVW-03: a second at the highest frequency of each CPU, at its own filter.
TEST(ChannelInputs, HighestFrequencies) {
  for (const std::uint32_t kilohertz : {10u, 30u, 60u}) {
    Wired w(parameters(Evaluation::PulseDirection, kilohertz));
    w.pulses(signal::pulsesOf(std::int64_t{kilohertz} * 1'000'000, 500, Instant{0}));
    EXPECT_EQ(w.countAt(kSecond), static_cast<std::int32_t>(kilohertz * 1000)) << kilohertz;
  }
}

// CNT-OVW-04, CNT-ENC-01, CNT-ENC-02, CNT-ENC-03
TEST(ChannelInputs, EncoderEvaluations) {
  struct Row {
    Evaluation evaluation;
    std::int32_t factor;
  };
  for (const Row& row :
       {Row{Evaluation::Single, 1}, Row{Evaluation::Double, 2}, Row{Evaluation::Quadruple, 4}})
    for (const std::int64_t frequency : {60'000'000, -60'000'000}) {
      Wired w(parameters(row.evaluation));
      w.encoder({Instant{0}, 0, frequency, 4 * 60'000});
      EXPECT_EQ(w.countAt(kTwoSeconds), (frequency > 0 ? 60'000 : -60'000) * row.factor);
    }
}

// CNT-SIM-06: there and back; the speed does not matter.
TEST(ChannelInputs, ReversingEncoderReturns) {
  Wired w(parameters(Evaluation::Quadruple));
  Motion motion{Instant{1'000'000}, 0, 1'000'000, 401};
  w.encoder(motion);
  EXPECT_EQ(w.countAt(kSecond), 401);
  w.encoder({kSecond, 401, -3'333'333, 401});
  EXPECT_EQ(w.countAt(kTwoSeconds), 0);
}

// CNT-OVW-06, CNT-PARAM-10, CNT-ENC-07, CNT-SIM-12
TEST(ChannelInputs, ShortPulsesAreSuppressed) {
  const auto count = [](std::uint32_t kilohertz, std::int64_t high, std::int64_t low) {
    Wired w(parameters(Evaluation::PulseDirection, kilohertz));
    signal::Pulses p;
    p.period = {high + low, 1};
    p.high = high;
    p.count = 100;
    w.pulses(p);
    return w.countAt(kSecond);
  };
  EXPECT_EQ(count(60, 8'000, 8'000), 100);
  EXPECT_EQ(count(60, 7'000, 7'000), 0);
  struct Row {
    std::uint32_t kilohertz;
    std::int64_t width;  // ns
  };
  for (const Row& row :
       {Row{30, 16'000}, Row{10, 48'000}, Row{5, 96'000}, Row{2, 240'000}, Row{1, 480'000}}) {
    EXPECT_EQ(count(row.kilohertz, row.width, row.width), 100) << row.kilohertz;
    EXPECT_EQ(count(row.kilohertz, row.width - 1000, row.width), 0) << row.kilohertz;
  }
}

// The closed form against every single edge: a comparison value and a limit on the way.
TEST(ChannelInputs, InOneStepAsEdgeByEdge) {
  for (const std::int32_t comparison : {5, 777, 30'001}) {
    io::CountChannel p = parameters(Evaluation::Quadruple);
    p.mode = io::CountMode::Periodic;
    p.direction = io::CountDirection::Forward;
    p.endValue = 40'000;
    p.output = io::CountOutput::AtLeast;
    p.comparison = comparison;
    Wired once(p), often(p);
    for (Wired* w : {&once, &often}) w->encoder({Instant{12'345}, 3, 59'999'321, 0});
    std::int64_t now = 0;
    for (std::int64_t step = 1; now < 400'000'000; step = step * 7 % 9973) {
      now += step;
      often.channel.advance(Instant{now});
    }
    EXPECT_EQ(once.countAt(Instant{now}), often.counter().count()) << comparison;
    EXPECT_EQ(once.counter().output(), often.counter().output());
    EXPECT_EQ(once.counter().overflow(), often.counter().overflow());
  }
}

// CNT-CMP-18: not before it happens, and never too late.
TEST(ChannelInputs, TheNextEventIsThePulseThatReachesTheValue) {
  io::CountChannel p = parameters(Evaluation::PulseDirection);
  p.output = io::CountOutput::AtLeast;
  p.comparison = 300;
  Wired w(p);
  w.pulses(signal::pulsesOf(10'000'000, 500, Instant{0}));
  int calls = 0;
  while (!w.counter().output() && ++calls < 100) w.channel.advance(w.channel.next());
  EXPECT_LT(calls, 40);
  EXPECT_EQ(w.counter().count(), 300);
  EXPECT_EQ(w.counter().output(), true);
}

// CNT-PERIOD-06
TEST(ChannelInputs, PeriodOfAnEncoder) {
  Wired w(parameters(Evaluation::Quadruple, 1));
  w.encoder({Instant{0}, 0, 100'000, 0});
  w.channel.advance(kSecond);
  EXPECT_EQ(w.counter().period(), 20'000u);
}

// CNT-GATE-09, CNT-LATCH-05
TEST(ChannelInputs, GateBeforePulseAtTheSameInstant) {
  io::CountChannel p = parameters(Evaluation::PulseDirection, 10);
  p.hardwareGate = true;
  Wired w(p);
  const auto both = [&](std::int64_t us, bool gate, bool pulse) {
    const Instant now{us * 1000};
    w.channel.advance(now);
    w.channel.set(Channel::GateInput, gate, nullptr, now);
    w.channel.set(Channel::TrackA, pulse, nullptr, now);
    return w.countAt(now + Duration::microseconds(200));
  };
  EXPECT_EQ(both(1000, true, true), 1);
  EXPECT_EQ(both(2000, true, false), 1);
  EXPECT_EQ(both(3000, false, true), 1);
  w.channel.set(Channel::LatchInput, true, nullptr, Instant{4'000'000});
  w.channel.set(Channel::LatchInput, false, nullptr, Instant{4'040'000});  // 40 us: too short
  w.channel.advance(kSecond);
  EXPECT_EQ(w.counter().latched(), 0);
}

// The same seed, the same edges.
TEST(PulseTrains, SeededJitter) {
  signal::Pulses p = signal::pulsesOf(1'000'000, 500, Instant{0});
  p.jitter = 200;
  p.seed = 7;
  const signal::PulseTrain one(p), two(p);
  p.seed = 8;
  const signal::PulseTrain other(p);
  Instant at = one.next(Instant{-1}), last = at;
  bool differs = false;
  for (int i = 0; i < 1000; ++i) {
    const Instant next = one.next(at);
    EXPECT_EQ(two.next(at), next);
    EXPECT_GT(next, at);
    differs = differs || other.next(at) != next;
    last = at;
    at = next;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(one.last(at), at);
  EXPECT_EQ(one.last(at - Duration{1}), last);
}

}  // namespace
}  // namespace merker::technology
