// A channel of the sub-module: its inputs, and the function that takes what they deliver. It goes
// from event to event, and over whole periods of even signals in one step.
#pragma once

#include <array>
#include <memory>

#include "technology/function.h"
#include "technology/input.h"

namespace merker::technology {

class Channel {
 public:
  // In the order in which they act at the same instant (CNT-SIM-05).
  enum Name : std::uint8_t { GateInput, LatchInput, TrackB, TrackA };
  static constexpr std::size_t kInputs = 4;

  Channel() = default;  // not parametrised
  // `highest`: kHz of the CPU.
  Channel(const io::CountChannel& parameters, std::uint32_t highest);

  void start(Instant now);
  void stop();
  void set(Name input, bool level, std::shared_ptr<const signal::Signal> signal, Instant now);
  void advance(Instant now);
  // When something happens that is seen outside; never() if nobody looks. May be early.
  Instant next() const;
  // The same with the levels of the inputs that pass their filter.
  Instant nextVisible() const;

  Function* function() { return function_.get(); }
  const Function* function() const { return function_.get(); }
  bool level(Name input) const { return inputs_[input].passed(); }

 private:
  // What one period of the signals counts: known when two whole ones counted the same, one way
  // only. The first one may lack what the filter still holds.
  struct Pattern {
    Instant begin = Instant::never();            // a rising edge of A
    std::uint64_t up = 0, down = 0;              // pulses since then
    std::uint64_t upBefore = 0, downBefore = 0;  // of the period before
    bool whole = false, known = false;
    std::uint64_t pulses() const { return upBefore + downBefore; }
    int direction() const { return upBefore > 0 ? 1 : -1; }
  };
  // The last two pulses: by which input's edge they came.
  struct Pulse {
    Name input = TrackA;
    Instant edge = signal::kLongAgo;
  };

  Instant nextInput() const;
  void handle(Instant at);
  void passed(Name input, Instant at);
  void countPulse(int direction, Name input, Instant at);
  void closePeriod();
  signal::Rhythm rhythm() const;
  std::int64_t skippable(Instant now) const;
  void skip(Instant now);
  Instant pulseTime(const Pulse& pulse) const { return pulse.edge + inputs_[pulse.input].filter(); }
  Instant nextPulse() const;

  io::CountChannel parameters_;
  std::unique_ptr<Function> function_;
  std::array<Input, kInputs> inputs_;
  Pattern pattern_;
  std::array<Pulse, 2> last_;
};

}  // namespace merker::technology
