// The clock memory byte (S7-MEM-01): eight square waves, asynchronous to the cycle. Its value is a
// function of virtual time; the CPU writes it to the flag at each instant at which a bit can
// change.
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

// All bits at this time.
std::uint8_t clockMemory(Instant now);
// The first instant after now at which a bit may change.
Instant nextClockMemory(Instant now);

}  // namespace merker::cpu
