// A pulse generator: pulses of one frequency and duty, endless or so many, with seeded jitter.
#pragma once

#include "signal/signal.h"

namespace merker::signal {

struct Pulses {
  Instant start;             // of the first pulse
  Period period;             // length of pulse and pause together
  std::int64_t high = 0;     // length of the pulse, in the denominator of `period`
  std::int64_t count = 0;    // 0: endless
  std::uint32_t jitter = 0;  // each edge is off by up to so many thousandths of the period
  std::uint64_t seed = 1;    // the same seed, the same edges
};

// By frequency in mHz and duty in thousandths; both as scenarios write them.
Pulses pulsesOf(std::int64_t millihertz, std::uint32_t duty, Instant start);
// What jitter the pulses allow: edges must not change their order.
std::uint32_t mostJitter(const Pulses& pulses);

class PulseTrain : public Signal {
 public:
  explicit PulseTrain(Pulses pulses) : pulses_(pulses), grid_{pulses.start, pulses.period} {}
  bool level(Instant t) const override { return edgesUntil(t) % 2 != 0; }
  Instant next(Instant after) const override;
  Instant last(Instant at) const override;
  Rhythm rhythm(Instant from) const override;
  Instant later(Instant edge, std::int64_t periods) const override;

 private:
  // Edges have numbers: 0 the first rising one, 1 the first falling one.
  Instant edge(std::int64_t number) const;
  std::int64_t edgesUntil(Instant t) const;
  std::int64_t displacement(std::int64_t number) const;

  Pulses pulses_;
  Grid grid_;
};

}  // namespace merker::signal
