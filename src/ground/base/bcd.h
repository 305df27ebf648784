// Binary coded decimal as counters, timers and clocks of S7 hold it.
#pragma once

#include <cstdint>
#include <optional>

namespace merker {

// 0..99 to one BCD byte; larger values lose their hundreds.
constexpr std::uint8_t toBcd(unsigned value) {
  return static_cast<std::uint8_t>((value / 10 % 10) << 4 | value % 10);
}

// `digits` decimal digits of value, least significant nibble last.
constexpr std::uint32_t toBcd(std::uint32_t value, int digits) {
  std::uint32_t result = 0;
  for (int i = 0; i < digits; ++i, value /= 10) result |= (value % 10) << (4 * i);
  return result;
}

// The number in `digits` BCD nibbles, nothing if a nibble is above 9.
constexpr std::optional<std::uint32_t> fromBcd(std::uint32_t bcd, int digits) {
  std::uint32_t result = 0;
  for (int i = digits - 1; i >= 0; --i) {
    const std::uint32_t digit = bcd >> (4 * i) & 0xF;
    if (digit > 9) return std::nullopt;
    result = result * 10 + digit;
  }
  return result;
}

}  // namespace merker
