// One character on the line: start bit, data bits, parity bit, stop bits (technology manual 6.1.5).
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::serial {

enum class Parity : std::uint8_t { None, Odd, Even };

struct Frame {
  std::uint8_t dataBits = 8;
  Parity parity = Parity::Even;
  std::uint8_t stopBits = 1;

  constexpr unsigned bits() const {
    return 1U + dataBits + (parity == Parity::None ? 0U : 1U) + stopBits;
  }
  constexpr std::uint8_t mask() const { return dataBits == 7 ? 0x7F : 0xFF; }
  auto operator<=>(const Frame&) const = default;
};

// Bit 0 is first on the line: start, least significant data bit first, parity, stop (PTP-PHY-11).
std::uint16_t encode(const Frame& frame, std::uint8_t value);

struct Decoded {
  std::uint8_t value = 0;
  bool parityFault = false, frameFault = false;
};
Decoded decode(const Frame& frame, std::uint16_t bits);

// The time that so many bits take, to the nearest nanosecond. Up to 9e9 bits.
constexpr Duration bitTime(std::int64_t bits, std::uint32_t baud) {
  return {(bits * 1'000'000'000 + baud / 2) / baud};
}
constexpr Duration characterTime(const Frame& frame, std::uint32_t baud) {
  return bitTime(frame.bits(), baud);
}

}  // namespace merker::serial
