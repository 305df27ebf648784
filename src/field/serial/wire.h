// A pair of wires: the characters that senders put on it, and its level at any instant. A character
// is a pattern of bits with a start and a rate, so a receiver of another rate, frame or polarity
// sees what a real one would see.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "clock/instant.h"

namespace merker::serial {

struct Burst {
  Instant start;
  std::uint32_t baud = 9600;
  std::uint16_t bits = 0;  // bit 0 first
  std::uint8_t count = 0;
  std::uint8_t sender = 0;
  bool noise = false;    // stronger than a sender
  bool overrun = false;  // the receiver loses the character before it

  Instant edge(unsigned index) const;  // where bit `index` begins
  Instant end() const { return edge(count); }
  bool covers(Instant t) const { return start <= t && t < end(); }
  bool level(Instant t) const { return (bits >> index(t) & 1U) != 0; }
  Instant boundaryAfter(Instant t) const;
  bool overlaps(Instant from, Instant to) const;

 private:
  unsigned index(Instant t) const;
};

class Wire {
 public:
  void put(const Burst& burst) { bursts_.push_back(burst); }
  // Senders that drive the idle level between their characters (RS 422 point-to-point, master).
  void hold(bool holds) { holders_ += holds ? 1 : -1; }

  bool level(Instant t, bool undriven) const;
  // The bits of a character that begins then, if nothing else is on the wire while it lasts.
  std::optional<std::uint16_t> alone(Instant start, std::uint32_t baud, unsigned count) const;
  Instant boundaryAfter(Instant t) const;  // the next instant at which the level may change
  // Two senders at the same time, or a lost character, within [from, to).
  bool collided(Instant from, Instant to) const;
  bool overrun(Instant from, Instant to) const;
  void forget(Instant before);  // nobody asks for earlier instants any more

 private:
  std::deque<Burst> bursts_;
  int holders_ = 0;
};

}  // namespace merker::serial
