// The status word, bit by bit (S7-STW-01 … -15). Code uses the English names; German: er /ER, rlo
// VKE, sta STA, or OR, os OS, ov OV, cc0 A0, cc1 A1, br BIE.
#pragma once

#include <cstdint>

namespace merker::cpu {

struct StatusWord {
  // These four are set together by calls and ends of blocks.
  bool er = false;     // bit 0: a chain has begun; 0 = the next logic operation is a first check
  bool sta = false;    // bit 2
  bool orBit = false;  // bit 3: AND result kept before O
  bool os = false;     // bit 4: stored overflow
  bool rlo = false;    // bit 1
  bool ov = false;     // bit 5
  bool cc0 = false;    // bit 6
  bool cc1 = false;    // bit 7
  bool br = false;     // bit 8
  bool operator==(const StatusWord&) const = default;

  std::uint16_t word() const {
    return static_cast<std::uint16_t>(er | rlo << 1 | sta << 2 | orBit << 3 | os << 4 | ov << 5 |
                                      cc0 << 6 | cc1 << 7 | br << 8);
  }
  static StatusWord fromWord(std::uint32_t w) {
    return {.er = (w & 0x001) != 0,
            .sta = (w & 0x004) != 0,
            .orBit = (w & 0x008) != 0,
            .os = (w & 0x010) != 0,
            .rlo = (w & 0x002) != 0,
            .ov = (w & 0x020) != 0,
            .cc0 = (w & 0x040) != 0,
            .cc1 = (w & 0x080) != 0,
            .br = (w & 0x100) != 0};
  }
  // Ends the chain as S, R, =, timers and counters do: OR 0, /ER 0.
  void endChain() { orBit = er = false; }
  // A1 A0 by sign (S7-STW-09): 00 zero, 01 negative, 10 positive.
  template <typename Number>
  void setSign(Number value) {
    cc0 = value < 0;
    cc1 = value > 0;
  }
};

}  // namespace merker::cpu
