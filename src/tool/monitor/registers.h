// The registers of a machine as program status and the stacks show them, for either family.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace merker::monitor {

struct Registers {
  std::uint8_t accumulators = 2;  // of this machine: 2 or 4
  std::array<std::uint32_t, 4> accu{};
  // STEP 5: ANZ1, ANZ0, STATUS, VKE, ERAB.
  bool cc1 = false, cc0 = false, ov = false, os = false, orBit = false;
  bool sta = false, rlo = false, er = false;
  std::optional<bool> br;                 // STEP 5 has none
  std::uint16_t word = 0;                 // the status word; STEP 5: the byte of displays
  std::optional<std::uint32_t> ar1, ar2;  // STEP 5 has none
  std::uint16_t db = 0;                   // open data blocks, 0 = none
  std::optional<std::uint16_t> di;        // STEP 5 has none
};

// A bracket that is open.
struct Bracket {
  bool rlo = false, orBit = false;
};

}  // namespace merker::monitor
