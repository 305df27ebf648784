// Bytes that somebody outside holds at a value, bit by bit (test function of the simulator; the
// original has none).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace merker::sinumerik {

template <std::size_t Bytes>
class Forces {
 public:
  void set(std::size_t byte, std::uint8_t mask, std::uint8_t value) {
    mask_[byte] |= mask;
    value_[byte] = static_cast<std::uint8_t>((value_[byte] & ~mask) | (value & mask));
  }
  void clear() { mask_.fill(0); }
  bool any() const {
    return std::ranges::any_of(mask_, [](std::uint8_t mask) { return mask != 0; });
  }
  void apply(std::array<std::uint8_t, Bytes>& bytes) const {
    for (std::size_t i = 0; i < Bytes; ++i)
      bytes[i] = static_cast<std::uint8_t>((bytes[i] & ~mask_[i]) | (value_[i] & mask_[i]));
  }

 private:
  std::array<std::uint8_t, Bytes> mask_{}, value_{};
};

}  // namespace merker::sinumerik
