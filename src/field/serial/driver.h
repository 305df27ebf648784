// A protocol as seen from the line: it takes characters with their times and is asked for the next
// one to send. It knows neither wires nor CPUs.
#pragma once

#include <cstdint>
#include <optional>

#include "clock/instant.h"

namespace merker::serial {

struct Character {
  static constexpr std::uint8_t kParity = 1, kFrame = 2, kOverrun = 4;
  std::uint8_t value = 0;
  std::uint8_t faults = 0;
  Instant at;  // the end of its last stop bit
  bool good() const { return faults == 0; }
  bool is(std::uint8_t wanted) const { return good() && value == wanted; }
};

class Driver {
 public:
  virtual ~Driver() = default;

  virtual void start(Instant now) = 0;  // ready for operation: parametrised, power on
  virtual void received(const Character& character) = 0;
  virtual void interrupted(Instant at) = 0;  // BREAK on the receive line
  virtual void restored(Instant at) = 0;
  // The next character to send, asked for while the line is free; `sent`: it has left the line,
  // with its last stop bit.
  virtual std::optional<std::uint8_t> next(Instant now) = 0;
  virtual void sent(Instant at) = 0;
  // Its own time: when, and that it has come.
  virtual Instant due() const = 0;
  virtual void expire(Instant now) = 0;
};

}  // namespace merker::serial
