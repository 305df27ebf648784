// The registers of an S7 CPU (S7-REG-01 … -04).
#pragma once

#include <array>
#include <cstdint>

#include "cpu/status_word.h"

namespace merker::cpu {

// DB or DI register: number and place of the open block; number 0 = none open.
struct OpenBlock {
  std::uint8_t* data = nullptr;
  std::uint32_t length = 0;
  std::uint32_t writable = 0;  // bytes that may be written: 0 in a write-protected block
  std::uint16_t number = 0;
  bool operator==(const OpenBlock&) const = default;
};

struct Registers {
  std::array<std::uint32_t, 4> accu{};
  std::uint32_t ar1 = 0, ar2 = 0;
  OpenBlock db, di;
  StatusWord status;
  bool operator==(const Registers&) const = default;

  // AKKU2 := AKKU1; AKKU1 := value: every load (S7-INSTR-38).
  void load(std::uint32_t value) {
    accu[1] = accu[0];
    accu[0] = value;
  }
  std::uint16_t low(unsigned n) const { return static_cast<std::uint16_t>(accu[n]); }
  void setLow(std::uint32_t value) { accu[0] = (accu[0] & 0xFFFF0000u) | (value & 0xFFFFu); }
};

}  // namespace merker::cpu
