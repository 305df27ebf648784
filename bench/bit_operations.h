// 10,000 bit operations, the same as AWL and as C++: groups of U, UN, O and =.
#pragma once

#include <cstdint>

namespace merker::bench {

constexpr unsigned kBitGroups = 2500, kOperationsPerGroup = 4;

struct Bit {
  std::uint8_t byte, bit;
};
struct BitGroup {
  Bit input, flag, orInput, output;
};

// Spread over 64 bytes of each area; any odd multipliers will do.
constexpr BitGroup bitGroup(unsigned i) {
  const auto bit = [i](unsigned k) {
    const std::uint32_t x = (i * 4 + k) * 2654435761u;
    return Bit{static_cast<std::uint8_t>(x >> 20 & 63), static_cast<std::uint8_t>(x >> 28 & 7)};
  };
  return {bit(0), bit(1), bit(2), bit(3)};
}

// The C++ one, over input, output and flag bytes.
struct BitMemory {
  std::uint8_t inputs[64], outputs[64], flags[64];
};
void bitOperations(BitMemory& memory);

}  // namespace merker::bench
