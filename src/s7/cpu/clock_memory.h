// The clock memory byte (S7-MEM-01): eight square waves, asynchronous to the cycle. Its value is a
// function of virtual time; the CPU writes it to the flag at each instant at which a bit can
// change.
#pragma once

#include <cstdint>
#include <optional>

#include "clock/instant.h"
#include "cpu/areas.h"

namespace merker::cpu {

// All bits at this time.
std::uint8_t clockMemory(Instant now);
// The first instant after now at which a bit may change.
Instant nextClockMemory(Instant now);

class ClockMemory {
 public:
  // `flag`: number of the flag byte; nothing: the CPU has no clock memory.
  explicit ClockMemory(std::optional<std::uint32_t> flag);
  Instant next() const { return next_; }
  // Writes the flag if it is time.
  void update(Areas& areas, Instant now);

 private:
  std::optional<std::uint32_t> flag_;
  Instant next_;
};

}  // namespace merker::cpu
