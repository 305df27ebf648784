// How long a DP master needs for its slaves (docs/compatibility.md, "PROFIBUS-DP").
#pragma once

#include <cstdint>
#include <vector>

#include "clock/instant.h"
#include "io/slave.h"

namespace merker::profibus {

// Bit times of one slave's turn: request and answer with their frames and pauses, and 11 bits for
// each byte of data.
constexpr std::int64_t kTurnBits = 317, kBitsPerByte = 11;
// Once in each cycle: token and a request for a station that may be missing.
constexpr std::int64_t kTokenBits = 300;

struct BusCycle {
  Duration length;
  std::vector<Duration> begins, ends;  // of each slave's turn, from the beginning of the cycle
};

BusCycle busCycle(const io::DpMaster& master);

}  // namespace merker::profibus
