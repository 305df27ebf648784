// Parameter ZFPN: how a number of the NC stands in words of the PLC (6.3 FB 61/62 section 6,
// S5-FM-36 … -41).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "nc/number.h"

namespace merker::nc {

// In the order of the manual's table: B BCD, F 32-bit fixed point, BG as stored, BI bit pattern.
enum class Format : std::uint8_t {
  // clang-format off
  B0, B1, B2, B3, B4, B5, B6, B7, B8, B9,
  F0, F1, F2, F3, F4, F5, F6, F7, F8, F9,
  FA, FB, FC, FD, FE, FF, BG, BI
  // clang-format on
};

// The format that the two characters of a KC constant name.
std::optional<Format> parseFormat(std::uint16_t characters);
std::string_view name(Format format);
// Words that a value takes: 3, 2 or 1 (S5-FM-28).
unsigned wordCount(Format format);

// Formats of a data type, one bit each.
using FormatSet = std::uint32_t;
constexpr FormatSet only(Format f) { return FormatSet{1} << static_cast<unsigned>(f); }
constexpr FormatSet from(Format first, Format last) {
  return (only(last) << 1) - only(first);  // bits first … last
}

enum class InputSystem : std::uint8_t { Metric, Inch };
// Places behind the point of a position: 0.001 mm or 0.0001 inch.
constexpr unsigned positionPlaces(InputSystem s) { return s == InputSystem::Metric ? 3 : 4; }

// What a data type holds, as far as formats depend on it.
enum class Content : std::uint8_t {
  Floating,  // a number with its own point: R parameters, tool offsets
  Position,  // counted in the input resolution
  Whole,     // whole numbers
  Bits       // a byte
};

struct PlcValue {
  std::array<std::uint16_t, 3> words{};
  unsigned count = 1;
};

// Nothing if the number does not fit the format.
std::optional<PlcValue> encode(Number number, Format format, Content content, InputSystem system);
// Nothing if the words hold no number or one of more than eight digits.
std::optional<Number> decode(std::span<const std::uint16_t> words, Format format, Content content,
                             InputSystem system);

}  // namespace merker::nc
