// One S5 counter, 0 … 999, with an edge memory for each of its instructions (S7-CNT).
#pragma once

#include <cstdint>

namespace merker::cpu {

struct S5Counter {
  std::uint16_t count = 0;
  bool setEdge = false, upEdge = false, downEdge = false, enableEdge = false;
  bool operator==(const S5Counter&) const = default;

  void up(bool rlo);    // ZV
  void down(bool rlo);  // ZR
  // S: the count from BCD bits 0..11. False: edge, but no BCD number (S7-CNT-03).
  bool set(bool rlo, std::uint16_t bcd);
  void reset(bool rlo);   // R
  void enable(bool rlo);  // FR
  std::uint16_t bcd() const;
};

}  // namespace merker::cpu
