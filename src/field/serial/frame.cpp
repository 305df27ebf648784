#include "serial/frame.h"

#include <bit>

namespace merker::serial {
namespace {

bool parityBit(const Frame& frame, std::uint8_t value) {
  const bool odd = std::popcount(value) % 2 != 0;
  return frame.parity == Parity::Even ? odd : !odd;
}

std::uint16_t stopBits(const Frame& frame) {
  const unsigned below = frame.bits() - frame.stopBits;
  return static_cast<std::uint16_t>(((1U << frame.stopBits) - 1U) << below);
}

}  // namespace

std::uint16_t encode(const Frame& frame, std::uint8_t value) {
  const auto data = static_cast<std::uint8_t>(value & frame.mask());
  unsigned bits = stopBits(frame) | static_cast<unsigned>(data) << 1U;
  if (frame.parity != Parity::None && parityBit(frame, data)) bits |= 1U << (1U + frame.dataBits);
  return static_cast<std::uint16_t>(bits);
}

Decoded decode(const Frame& frame, std::uint16_t bits) {
  Decoded result;
  result.value = static_cast<std::uint8_t>(bits >> 1U & frame.mask());
  if (frame.parity != Parity::None)
    result.parityFault =
        ((bits >> (1U + frame.dataBits) & 1U) != 0) != parityBit(frame, result.value);
  result.frameFault = (bits & stopBits(frame)) != stopBits(frame);
  return result;
}

}  // namespace merker::serial
