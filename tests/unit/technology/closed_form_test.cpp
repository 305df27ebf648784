// The closed form against every single edge: random channels at random signals, one of them looked
// at seldom, the other one's signals without a rhythm, so that no period is skipped.
#include <gtest/gtest.h>

#include <random>

#include "signal/encoder.h"
#include "signal/pulse_train.h"
#include "technology/channel.h"
#include "technology/counter.h"
#include "technology/frequency.h"

namespace merker::technology {
namespace {

class WithoutRhythm : public signal::Signal {
 public:
  explicit WithoutRhythm(std::shared_ptr<const signal::Signal> signal)
      : signal_(std::move(signal)) {}
  bool level(Instant t) const override { return signal_->level(t); }
  Instant next(Instant after) const override { return signal_->next(after); }
  Instant last(Instant at) const override { return signal_->last(at); }
  signal::Rhythm rhythm(Instant) const override { return {}; }
  Instant later(Instant edge, std::int64_t) const override { return edge; }

 private:
  std::shared_ptr<const signal::Signal> signal_;
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool flag() { return between(0, 1) != 0; }

 private:
  std::mt19937_64 engine_;
};

io::CountChannel randomChannel(Random& random) {
  io::CountChannel p;
  p.mode = static_cast<io::CountMode>(random.between(1, 4));
  p.evaluation =
      static_cast<io::Evaluation>(random.between(0, p.mode == io::CountMode::Frequency ? 1 : 3));
  constexpr std::uint32_t kFrequencies[] = {60, 30, 10, 5, 2, 1};
  p.maxFrequency = kFrequencies[random.between(0, 5)];
  p.latchFrequency = 10;
  p.hardwareGate = random.flag();
  p.inverted = random.flag();
  p.onGateOpened = p.onComparator = p.onOverflow = p.onUnderflow = p.onMeasured = random.flag();
  p.onCountEdge = random.between(0, 9) == 0;
  if (p.mode != io::CountMode::Endless)
    p.direction = static_cast<io::CountDirection>(random.between(0, 2));
  p.endValue = static_cast<std::int32_t>(random.between(2, 400));
  p.interruptGate = random.flag();
  p.comparison = static_cast<std::int32_t>(random.between(-20, 400));
  p.hysteresis = random.flag() ? 0 : static_cast<std::int32_t>(random.between(0, 40));
  p.output = static_cast<io::CountOutput>(random.between(0, 3));
  p.pulseDuration = static_cast<std::int32_t>(random.between(0, 5)) * 2;
  p.integrationTime = static_cast<std::int32_t>(random.between(10, 200));
  p.averaged = random.flag();
  p.highLimit = 60'000'000;
  return p;
}

// All that can be seen of a channel; interrupts as often as they are asked for.
std::vector<std::int64_t> seen(Channel& channel) {
  if (auto* c = dynamic_cast<Counter*>(channel.function()))
    return {c->count(),
            c->latched(),
            c->overflow(),
            c->underflow(),
            c->zero(),
            c->output(),
            c->gateOpen(),
            c->down(),
            c->inputData(),
            c->period(),
            c->comparator().reached(),
            c->takeCauses()};
  auto& f = dynamic_cast<Frequency&>(*channel.function());
  return {f.value(), f.count(), f.down(), f.measured(), f.overflow(), f.takeCauses()};
}

class Pair {
 public:
  explicit Pair(const io::CountChannel& p) : closed_(p, 60), single_(p, 60) {
    for (Channel* channel : {&closed_, &single_}) channel->start({});
  }
  void control(bool gate, Instant now) {
    for (Channel* channel : {&closed_, &single_}) {
      channel->advance(now);
      if (auto* c = dynamic_cast<Counter*>(channel->function())) c->control(gate, true, false, now);
      if (auto* f = dynamic_cast<Frequency*>(channel->function()))
        f->control(gate, false, false, now);
    }
  }
  void set(Channel::Name input, std::shared_ptr<const signal::Signal> signal, Instant now) {
    const bool level = signal->level(now);
    for (Channel* channel : {&closed_, &single_}) channel->advance(now);
    closed_.set(input, level, signal, now);
    single_.set(input, level, std::make_shared<WithoutRhythm>(signal), now);
  }
  void set(Channel::Name input, bool level, Instant now) {
    for (Channel* channel : {&closed_, &single_}) {
      channel->advance(now);
      channel->set(input, level, nullptr, now);
    }
  }
  void compare(Instant now, std::uint64_t seed) {
    for (Channel* channel : {&closed_, &single_}) channel->advance(now);
    ASSERT_EQ(seen(closed_), seen(single_)) << "seed " << seed << " at " << now.ns;
  }

 private:
  Channel closed_, single_;
};

void drive(Random& random, const io::CountChannel& p, Pair& pair, Instant now) {
  const std::int64_t fastest = std::int64_t{p.maxFrequency} * 1'100'000;  // a little too fast, too
  const std::int64_t frequency = random.between(fastest / 50, fastest);
  if (p.evaluation != io::Evaluation::PulseDirection) {
    const signal::Motion motion{now, random.between(0, 7), random.flag() ? frequency : -frequency,
                                random.flag() ? 0 : random.between(1, 2000)};
    for (const auto track : {signal::Track::B, signal::Track::A})
      pair.set(track == signal::Track::A ? Channel::TrackA : Channel::TrackB,
               std::make_shared<signal::EncoderTrack>(motion, track), now);
    return;
  }
  signal::Pulses train =
      signal::pulsesOf(frequency, static_cast<std::uint32_t>(random.between(300, 700)), now);
  train.count = random.flag() ? 0 : random.between(1, 1000);
  pair.set(Channel::TrackA, std::make_shared<signal::PulseTrain>(train), now);
  if (random.flag()) pair.set(Channel::TrackB, random.flag(), now);
}

void act(Random& random, const io::CountChannel& p, Pair& pair, Instant now) {
  switch (random.between(0, 5)) {
    case 0:
      return pair.set(Channel::GateInput, random.flag(), now);
    case 1:
      return pair.set(Channel::LatchInput, random.flag(), now);
    case 2:
      return pair.control(random.between(0, 3) != 0, now);
    case 3:
      return drive(random, p, pair, now);
    default:
      return;
  }
}

void check(std::uint64_t seed) {
  Random random(seed);
  const io::CountChannel p = randomChannel(random);
  Pair pair(p);
  Instant now{1'000'000};
  pair.control(true, now);
  pair.set(Channel::GateInput, true, now);
  drive(random, p, pair, now);
  for (int step = 0; step < 30 && !testing::Test::HasFatalFailure(); ++step) {
    now = now + Duration{random.between(1, 60'000'000)};
    pair.compare(now, seed);
    act(random, p, pair, now);
  }
}

TEST(ClosedForm, AsEdgeByEdge) {
  for (std::uint64_t seed = 1; seed <= 300 && !HasFatalFailure(); ++seed) check(seed);
  check(2436);  // levels that last as long as the filter, but for a nanosecond
}

}  // namespace
}  // namespace merker::technology
