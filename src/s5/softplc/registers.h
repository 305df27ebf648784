// Registers of the STEP 5 processor and the result displays (S5-NUM-01, S5-STAT-01).
#pragma once

#include <cstdint>
#include <vector>

namespace merker::sinumerik {

// Bit 7 … 0 of the display byte: ANZ1 ANZ0 OV OS OR STATUS VKE ERAB (OP-23).
struct Displays {
  bool anz1 = false, anz0 = false, ov = false, os = false;
  bool orBit = false, status = false, vke = false;
  bool chain = false;  // ERAB: a chain is in progress, the next scan is not its first (OP-51)

  std::uint8_t byte() const {
    return static_cast<std::uint8_t>(anz1 << 7 | anz0 << 6 | ov << 5 | os << 4 | orBit << 3 |
                                     status << 2 | vke << 1 | (chain ? 1 : 0));
  }
  void setAnz(bool high, bool low) {
    anz1 = high;
    anz0 = low;
  }
  void overflow(bool happened) {
    ov = happened;
    os = os || happened;
  }
};

// What U( and O( save until ).
struct Bracket {
  bool vke = false, orBit = false, isOr = false;
};

struct Registers {
  std::uint32_t akku1 = 0, akku2 = 0;
  Displays displays;
  std::vector<Bracket> brackets;

  std::uint16_t low1() const { return static_cast<std::uint16_t>(akku1); }
  std::uint16_t low2() const { return static_cast<std::uint16_t>(akku2); }
  void setLow1(std::uint16_t word) { akku1 = (akku1 & 0xFFFF0000) | word; }
  // L: AKKU 1 moves to AKKU 2, unused bits become 0 (S5-LOAD-04).
  void load(std::uint32_t value) {
    akku2 = akku1;
    akku1 = value;
  }
};

}  // namespace merker::sinumerik
