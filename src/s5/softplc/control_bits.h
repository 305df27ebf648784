// The control bits that the programmer shows in STOP (S5-ERR-T1): eight bytes of named bits.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker::sinumerik {

enum class ControlBit : std::uint8_t {
  NONE,
#define CONTROL_BIT(id, name, byte, bit, meaning) id,
#include "softplc/control_bits.inc"
#undef CONTROL_BIT
};

struct ControlBitRow {
  ControlBit id;
  std::string_view name;
  unsigned byte, bit;  // byte 1..8 from the top, bit 7 leftmost
  std::string_view meaning;
};
std::span<const ControlBitRow> controlBitRows();

class ControlBits {
 public:
  constexpr void set(ControlBit bit, bool on = true) {
    bits_ = on ? bits_ | mask(bit) : bits_ & ~mask(bit);
  }
  constexpr bool test(ControlBit bit) const { return (bits_ & mask(bit)) != 0; }
  std::uint8_t row(unsigned byte) const;  // 1..8 as on the screen
  bool operator==(const ControlBits&) const = default;

 private:
  static constexpr std::uint64_t mask(ControlBit bit) {
    return bit == ControlBit::NONE ? 0 : std::uint64_t{1} << static_cast<unsigned>(bit);
  }
  std::uint64_t bits_ = 0;
};

}  // namespace merker::sinumerik
