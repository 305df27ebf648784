// CRC-32 (IEEE 802.3): SQLite guards the structure of a database, this the bytes in it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace merker::store {

constexpr std::array<std::uint32_t, 256> crc32Table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t sum = i;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? sum >> 1 ^ 0xEDB88320u : sum >> 1;
    table[i] = sum;
  }
  return table;
}

constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint32_t, 256> kTable = crc32Table();
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const std::uint8_t byte : bytes) sum = sum >> 8 ^ kTable[(sum ^ byte) & 0xFF];
  return ~sum;
}

}  // namespace merker::store
