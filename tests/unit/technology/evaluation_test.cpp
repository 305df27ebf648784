// What the edges of the two tracks count, one by one (technology manual 5.10.2), and which input
// acts first.
#include <gtest/gtest.h>

#include "technology/channel.h"
#include "technology/counter.h"

namespace merker::technology {
namespace {

using io::Evaluation;

// Levels at the inputs, 1 ms apart; what is given together changes at one instant.
class Bench {
 public:
  explicit Bench(Evaluation evaluation, bool inverted = false, bool hardwareGate = false)
      : channel_(parameters(evaluation, inverted, hardwareGate), 60) {
    channel_.start({});
    counter().control(true, true, false, {});
  }
  std::int32_t set(std::initializer_list<std::pair<Channel::Name, bool>> levels) {
    now_ = now_ + Duration::milliseconds(1);
    channel_.advance(now_);
    for (const auto& [input, level] : levels) channel_.set(input, level, nullptr, now_);
    channel_.advance(now_ + Duration::microseconds(500));
    return counter().count();
  }
  Counter& counter() { return dynamic_cast<Counter&>(*channel_.function()); }

 private:
  static io::CountChannel parameters(Evaluation evaluation, bool inverted, bool hardwareGate) {
    io::CountChannel p;
    p.mode = io::CountMode::Endless;
    p.evaluation = evaluation;
    p.maxFrequency = p.latchFrequency = 60;
    p.inverted = inverted;
    p.hardwareGate = hardwareGate;
    return p;
  }
  Channel channel_;
  Instant now_;
};

constexpr auto A = Channel::TrackA, B = Channel::TrackB;

// The counts of the edges A+, B+, A-, B-: one period forward.
std::vector<std::int32_t> forward(Bench& bench) {
  return {bench.set({{A, true}}), bench.set({{B, true}}), bench.set({{A, false}}),
          bench.set({{B, false}})};
}
std::vector<std::int32_t> backward(Bench& bench) {
  return {bench.set({{B, true}}), bench.set({{A, true}}), bench.set({{B, false}}),
          bench.set({{A, false}})};
}

using Counts = std::vector<std::int32_t>;

// CNT-ENC-01, CNT-ENC-02, CNT-ENC-03
TEST(Evaluation, EachEdge) {
  struct Row {
    Evaluation evaluation;
    Counts forward, backward;
  };
  const Row rows[] = {{Evaluation::Single, {1, 1, 1, 1}, {0, -1, -1, -1}},
                      {Evaluation::Double, {1, 1, 2, 2}, {0, -1, -1, -2}},
                      {Evaluation::Quadruple, {1, 2, 3, 4}, {-1, -2, -3, -4}}};
  for (const Row& row : rows) {
    Bench one(row.evaluation), other(row.evaluation);
    EXPECT_EQ(forward(one), row.forward);
    EXPECT_EQ(backward(other), row.backward);
  }
}

// CNT-ENC-04, CNT-PERI-07, CNT-PARAM-13: B is the direction, and may be inverted.
TEST(Evaluation, PulseAndDirection) {
  Bench bench(Evaluation::PulseDirection), inverted(Evaluation::PulseDirection, true);
  for (Bench* one : {&bench, &inverted})
    for (int i = 0; i < 3; ++i) one->set({{A, true}}), one->set({{A, false}});
  EXPECT_EQ(bench.counter().count(), 3);
  EXPECT_EQ(inverted.counter().count(), -3);
  bench.set({{B, true}});
  EXPECT_EQ(bench.set({{A, true}}), 2);
  EXPECT_TRUE(bench.counter().down());
}

// CNT-ENC-05: B is turned before the evaluation.
TEST(Evaluation, InvertedEncoder) {
  Bench single(Evaluation::Single, true);
  EXPECT_EQ(forward(single), (Counts{-1, -1, -1, -1}));
  Bench twice(Evaluation::Double, true);
  EXPECT_EQ(forward(twice), (Counts{-1, -1, -2, -2}));
  Bench four(Evaluation::Quadruple, true);
  EXPECT_EQ(forward(four), (Counts{-1, -2, -3, -4}));
}

// CNT-ENC-08: an axis that trembles at an edge of A drifts with single evaluation only.
TEST(Evaluation, TremblingAtStandstill) {
  for (const auto evaluation : {Evaluation::Single, Evaluation::Double, Evaluation::Quadruple}) {
    Bench bench(evaluation);
    for (int i = 0; i < 5; ++i) bench.set({{A, true}}), bench.set({{A, false}});
    EXPECT_EQ(bench.counter().count(), evaluation == Evaluation::Single ? 5 : 0);
  }
}

// CNT-ENC-06: both tracks at one instant is no error, A is taken first.
TEST(Evaluation, BothTracksAtOnce) {
  Bench four(Evaluation::Quadruple), single(Evaluation::Single);
  EXPECT_EQ(four.set({{B, true}, {A, true}}), 2);  // A+ with B = 0, then B+ with A = 1
  EXPECT_EQ(four.set({{B, false}, {A, false}}), 4);
  EXPECT_EQ(single.set({{B, true}, {A, true}}), 1);
}

// CNT-SIM-05: gate, latch, direction, pulse.
TEST(Evaluation, OrderAtOneInstant) {
  Bench bench(Evaluation::PulseDirection, false, true);
  EXPECT_EQ(
      bench.set({{A, true}, {B, true}, {Channel::LatchInput, true}, {Channel::GateInput, true}}),
      -1);                                  // the gate is open, and it counts down
  EXPECT_EQ(bench.counter().latched(), 0);  // as it was before the pulse
  bench.set({{A, false}, {Channel::LatchInput, false}});
  EXPECT_EQ(bench.set({{A, true}, {Channel::LatchInput, true}, {Channel::GateInput, false}}), -1);
  EXPECT_EQ(bench.counter().latched(), -1);
}

}  // namespace
}  // namespace merker::technology
