// What carries the telegrams of a subnet: how long they take (docs/compatibility.md, "Several
// stations").
#pragma once

#include <cstddef>
#include <cstdint>

#include "clock/instant.h"

namespace merker::network {

struct Medium {
  std::int64_t rate;     // bits per second
  std::int64_t pause;    // bits in front of a telegram
  std::int64_t frame;    // bytes of a telegram besides its data
  std::int64_t perByte;  // bits
  Duration latency;      // from the last bit on the line to its arrival
  // The sender learns that nobody has the address, or that the line is broken.
  bool acknowledged;
  // Each pair of stations has its turn: nobody waits for the line.
  bool inTurns = false;
};

// SYN of PROFIBUS (DIN 19245-1); SD2 LE LEr SD2 DA SA FC FCS ED and two SAPs; start, 8 bits,
// parity, stop.
constexpr Medium mpi(std::int64_t rate) { return {rate, 33, 9 + 2, 11, {}, true}; }
// Gap between two frames; preamble, addresses and check (IEEE 802.3), IP, TCP, TPKT, COTP.
constexpr Medium ethernet(std::int64_t rate) {
  return {rate, 96, 8 + 18 + 20 + 20 + 4 + 3, 8, Duration::microseconds(200), false};
}

// PROFIBUS-DP between two stations: a turn with its data (docs/compatibility.md, "PROFIBUS-DP"), of
// which a telegram has one byte more.
constexpr Medium dp(std::int64_t rate) { return {rate, 317, -1, 11, {}, false, true}; }

// Wires between two stations, which are no line and have no bits: how long a change needs is our
// own (docs/compatibility.md, "Several stations").
constexpr Medium wires() { return {1, 0, 0, 0, Duration::milliseconds(1), false, true}; }

// Bits of a telegram with this much data on the line, with the pause in front of it.
constexpr std::int64_t telegramBits(const Medium& medium, std::size_t bytes) {
  return medium.pause + medium.perByte * (medium.frame + static_cast<std::int64_t>(bytes));
}

}  // namespace merker::network
