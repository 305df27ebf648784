// Words of a STEP 5 memory as bytes, the high byte first.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"

namespace merker::mc5 {

inline std::vector<std::uint8_t> toBytes(const std::vector<std::uint16_t>& words) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * words.size());
  for (const std::uint16_t word : words) appendWord(bytes, word);
  return bytes;
}

inline std::vector<std::uint16_t> toWords(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) words.push_back(loadWord(&bytes[i]));
  return words;
}

}  // namespace merker::mc5
