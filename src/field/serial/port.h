// One station at a line: a driver with its sender and its receiver.
#pragma once

#include <functional>
#include <map>

#include "serial/fault.h"
#include "serial/receiver.h"

namespace merker::serial {

// For a monitor of the line: a character as it leaves a sender, or a BREAK, which begins and ends
// where a receiver sees it; `port` is then the side that should drive the pair.
struct Sighting {
  enum class Kind : std::uint8_t { Character, Interrupted, Restored };
  std::size_t port = 0;
  std::uint8_t value = 0;
  Instant start, end;
  std::uint8_t faults = 0;  // as Character has them
  Kind kind = Kind::Character;
  bool isCharacter() const { return kind == Kind::Character; }
};

class Port {
 public:
  Port(std::size_t number, Driver& driver, const Settings& settings, Wire& out, const Wire& in);

  Receiver& receiver() { return receiver_; }
  const Receiver& receiver() const { return receiver_; }
  // The character with this number (from 0, since the beginning) suffers the fault.
  void disturb(std::uint64_t index, const Fault& fault) { faults_[index] = fault; }
  void pace(Duration gap) { gap_ = gap; }  // idle time after each character, a part of it
  void listen(std::function<void(const Sighting&)> monitor) { monitor_ = std::move(monitor); }
  std::uint64_t characters() const { return index_; }

  Instant next() const;
  void finish(Instant now);   // a character has left
  void receive(Instant now);  // a character has arrived
  void run(Instant now);      // timers of the driver, then the next character

 private:
  void send(std::uint8_t value, Instant now);
  Emission shape(std::uint8_t value);
  void emit(std::uint16_t bits, Instant at, bool overrun);
  void see(Sighting::Kind kind, Instant now) const;
  void begin(Instant now);
  void finished(Duration extra);

  std::size_t number_;
  Driver& driver_;
  Settings settings_;
  Wire& out_;
  Receiver receiver_;
  std::map<std::uint64_t, Fault> faults_;
  std::function<void(const Sighting&)> monitor_;
  Duration gap_;
  std::uint64_t index_ = 0;
  bool sending_ = false;
  Instant base_, busyUntil_{INT64_MIN};  // bit times are counted from the base: no drift
  std::int64_t bits_ = 0;
};

}  // namespace merker::serial
