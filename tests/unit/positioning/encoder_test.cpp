// The encoder at its inputs: closed form, edge by edge, faults of the tracks (POS-ENC).
#include "signal/encoder.h"

#include <gtest/gtest.h>

#include <random>

#include "bench.h"
#include "positioning/encoder_input.h"

namespace merker::positioning {
namespace {

using Name = EncoderInput::Name;
constexpr Name kTracks[] = {Name::A, Name::B, Name::N};

// The same levels, but not known as a track of a ramp.
class Opaque : public signal::Signal {
 public:
  explicit Opaque(std::shared_ptr<const signal::Signal> signal) : signal_(std::move(signal)) {}
  bool level(Instant t) const override { return signal_->level(t); }
  Instant next(Instant after) const override { return signal_->next(after); }
  Instant last(Instant at) const override { return signal_->last(at); }
  signal::Rhythm rhythm(Instant) const override { return {}; }
  Instant later(Instant edge, std::int64_t) const override { return edge; }

 private:
  std::shared_ptr<const signal::Signal> signal_;
};

// A channel and its encoder; the position and how many marks there were.
struct Reader {
  explicit Reader(std::uint32_t kilohertz = 60) : input(kilohertz), channel(parameters()) {}
  static io::AxisChannel parameters() {
    io::AxisChannel p = analogAxis();
    p.monitors.missingPulse = true;
    return p;
  }
  void attach(Name name, std::shared_ptr<const signal::Signal> signal, Instant now) {
    const bool level = signal->level(now);
    input.set(name, level, std::move(signal), now, channel);
  }
  std::int64_t position(Instant now) {
    input.advance(now, channel);
    channel.cycle();
    return channel.image().position;
  }
  EncoderInput input;
  Channel channel;
};

std::shared_ptr<const signal::Ramp> ramp(Instant start, std::int64_t position, std::int64_t speed,
                                         std::int64_t last) {
  signal::Ramp ramp;
  ramp.start = start;
  ramp.position = position;
  ramp.speed = speed;
  ramp.last = last;
  return std::make_shared<const signal::Ramp>(ramp);
}

std::shared_ptr<const signal::Signal> track(const std::shared_ptr<const signal::Ramp>& ramp,
                                            Name name, const signal::ZeroMarks& marks = {}) {
  return std::make_shared<signal::RampTrack>(ramp, marks, name);
}

// POS-PLANT-11: ramps at random, looked at at any time: both ways count the same pulses, see the
// same marks, and both agree with the axis itself.
TEST(Encoder, ClosedFormAsEdgeByEdge) {
  std::mt19937_64 random(7);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  for (int round = 0; round < 20; ++round) {
    Reader closed, single;
    const signal::ZeroMarks marks{between(4, 50) * 4, between(-30, 30), round % 2 == 0};
    std::int64_t position = between(-5'000'000, 5'000'000), speed = 0;
    const std::int64_t first = signal::pulseOf(position);
    for (int step = 0; step < 50; ++step) {
      const Instant start{step * 4'000'000};
      const std::int64_t last = between(-40'000'000, 40'000'000);
      const auto moved = ramp(start, position, speed, last);
      for (const Name name : kTracks) {
        closed.attach(name, track(moved, name, marks), start);
        single.attach(name, std::make_shared<Opaque>(track(moved, name, marks)), start);
      }
      if (step == 0) {  // their levels at the beginning count nothing
        closed.channel.start();
        single.channel.start();
      }
      const Instant middle = start + Duration{between(1, 3'999'999)};
      closed.input.advance(middle, closed.channel);
      position = moved->end();
      speed = last;
      const Instant end = start + Duration::milliseconds(4);
      const std::int64_t expected = signal::pulseOf(position) - first;
      ASSERT_EQ(closed.position(end), expected) << round << " " << step;
      ASSERT_EQ(single.position(end), expected) << round << " " << step;
      ASSERT_EQ(closed.channel.image().errors, single.channel.image().errors);
      ASSERT_EQ(closed.channel.image().down, single.channel.image().down);
    }
  }
}

// POS-ENC-03, POS-ENC-04: a period of A and B is four pulses; A first is plus
TEST(Encoder, Quarters) {
  Reader r;
  const auto set = [&](Name name, bool level, std::int64_t us) {
    r.input.set(name, level, nullptr, Instant{us * 1000}, r.channel);
  };
  set(Name::A, true, 1);
  set(Name::B, true, 2);
  set(Name::A, false, 3);
  EXPECT_EQ(r.position(Instant{4000}), 3);
  set(Name::B, false, 5);
  EXPECT_EQ(r.position(Instant{6000}), 4);
  set(Name::B, true, 7);
  set(Name::A, true, 8);
  EXPECT_EQ(r.position(Instant{9000}), 2);
  EXPECT_TRUE(r.channel.image().down);
}

// POS-ENC-05, POS-WIRE-01: swapped wires count the other way, with the marks where they are
TEST(Encoder, SwappedTracks) {
  for (const bool swapped : {false, true}) {
    Reader r;
    const auto moved = ramp({}, 0, 10'000'000, 10'000'000);
    r.attach(Name::A, track(moved, swapped ? Name::B : Name::A), {});
    r.attach(Name::B, track(moved, swapped ? Name::A : Name::B), {});
    r.channel.start();
    EXPECT_EQ(r.position(Instant{4'000'000}), swapped ? -40 : 40);
  }
}

// POS-ENC-08, POS-PARAM-08: faster than the filter passes nothing counts
TEST(Encoder, Filter) {
  for (const std::uint32_t kilohertz : {60u, 10u, 1u}) {
    for (const std::int64_t percent : {100, 105}) {
      for (const bool opaque : {false, true}) {
        Reader r(kilohertz);
        const std::int64_t speed = std::int64_t{kilohertz} * 4'000'000 * percent / 100;
        const auto moved = ramp({}, 0, speed, speed);
        for (const Name name : {Name::A, Name::B}) {
          auto signal = track(moved, name);
          r.attach(name, opaque ? std::make_shared<Opaque>(signal) : signal, {});
        }
        r.channel.start();
        const std::int64_t counted = r.position(Instant{3'900'000});
        if (percent == 100) {
          EXPECT_EQ(counted, moved->pulseAt(Instant{3'900'000}));
        } else {
          EXPECT_LE(counted, 4);  // levels at the ends of the movement
        }
      }
    }
  }
}

// POS-ENC-07: both tracks at one instant
TEST(Encoder, BothTracksAtOnce) {
  Reader r;
  const signal::Motion motion{Instant{}, 1, 1'000'000};
  for (const Name name : {Name::A, Name::B})
    r.attach(name, std::make_shared<signal::EncoderTrack>(motion, signal::Track::A), {});
  r.channel.start();
  EXPECT_EQ(r.position(Instant{100'000'000}), 0);
}

// POS-REF-02, POS-WIRE-02: a reference-point run with the tracks of the axis, not with its pulses
class Tracks : public Bench {
 public:
  Tracks(const io::AxisChannel& parameters, std::int64_t pulse) : Bench(parameters, {}, pulse) {}
  void move() {
    const Instant start{4'000'000 * static_cast<std::int64_t>(cycles_++)};
    axis.step(inputs(), switches_);
    signal::Ramp moved = axis.ramp();
    moved.start = start;
    const auto shared = std::make_shared<const signal::Ramp>(moved);
    for (const Name name : kTracks) {
      const auto signal = track(shared, name);
      input_.set(name, signal->level(start), signal, start, channel);
    }
    if (cycles_ == 1) channel.start();
    for (const auto& [on, pulse] : switches_.edges) {
      input_.advance(shared->reaches(pulse), channel);
      channel.referenceSwitch(on);
    }
    switches_.edges.clear();
    input_.advance(start + kCycle, channel);
    channel.cycle();
  }

 private:
  struct Switches : plant::AxisObserver {
    void moved(std::int64_t) override {}
    void zeroMark() override {}
    void referenceSwitch(bool on) override { edges.emplace_back(on, on ? 30'300 : 35'300); }
    void lengthInput(bool) override {}
    std::vector<std::pair<bool, std::int64_t>> edges;
  };
  Switches switches_;
  EncoderInput input_{60};
  int cycles_ = 0;
};

TEST(Encoder, ReferenceRunByTracks) {
  io::AxisChannel p = analogAxis();
  p.reference = 500;
  Tracks b(p, 10'000);
  b.command.motion = motion(5000, 5000);
  b.move();
  b.command.mode = 3;
  ASSERT_EQ(b.press(&Command::plus), kNoError);
  int cycle = -1;
  do {
    b.move();
    ++cycle;
  } while (!b.image().synchronous && cycle < 3000);
  EXPECT_EQ(cycle, 2165);
  EXPECT_EQ(b.image().position, 500);
  while (b.image().working && cycle < 3000) {
    b.move();
    ++cycle;
  }
  EXPECT_EQ(cycle, 2215);
  EXPECT_EQ(b.image().position, 600);
}

}  // namespace
}  // namespace merker::positioning
