// The receiving half of an interface: finds start bits, samples in the middle of each bit with its
// own rate, and recognises characters, faults and BREAK.
#pragma once

#include <array>
#include <optional>

#include "serial/driver.h"
#include "serial/settings.h"
#include "serial/wire.h"

namespace merker::serial {

class Receiver {
 public:
  Receiver(const Wire& wire, const Settings& settings);

  // Everything before `now` happened under the conditions that hold until now. To be called before
  // these change.
  void observe(Instant now);
  void cut(bool open) { cut_ = open; }
  void swapPolarity(bool swapped) { swapped_ = swapped; }
  // A BREAK that began at another line goes on.
  bool interrupted() const { return state_ == State::Interrupted; }
  void interrupt(Instant now) {
    state_ = State::Interrupted;
    from_ = needs_ = now;
  }
  // Hears nothing from now on until then (half duplex).
  void mute(Instant until);

  struct Event {
    enum class Kind : std::uint8_t { Character, Interrupted, Restored };
    Kind kind = Kind::Character;
    Character character;
  };
  Instant next() const;                     // may be early
  std::optional<Event> take(Instant now);   // what is complete at `now`
  Instant needs() const { return needs_; }  // the earliest instant that it still looks at

 private:
  enum class State : std::uint8_t { Searching, Receiving, Interrupted };
  bool level(Instant t) const;
  Instant find(bool level, Instant from) const;
  Instant startBit() const;
  Instant sampleTime(unsigned bit) const { return start_ + samples_[bit]; }
  Instant lastSample() const { return sampleTime(frame_.bits() - 1); }
  Instant end() const { return start_ + length_; }
  void begin(Instant at);
  void sample(Instant until);
  bool takeWhole(Instant until);
  void search(Instant from, bool needsIdle);
  Event complete(Instant now);

  const Wire& wire_;
  Frame frame_;
  std::uint32_t baud_;
  Preset preset_;
  Duration length_;                   // of a character
  std::array<Duration, 12> samples_;  // the middle of each bit
  bool cut_ = false, swapped_ = false;
  State state_ = State::Searching;
  bool needsIdle_ = false;  // the line must be idle first
  Instant from_, start_, needs_;
  unsigned sampled_ = 0;
  std::uint16_t bits_ = 0;
};

}  // namespace merker::serial
