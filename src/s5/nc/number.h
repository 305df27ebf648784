// A number as the NC holds it: a sign, up to eight decimal digits, a decimal point.
#pragma once

#include <cstdint>
#include <optional>

namespace merker::nc {

struct Number {
  std::int32_t digits = 0;  // at most kMostDigits, either sign
  std::uint8_t places = 0;  // of them behind the point, 0..8
  bool operator==(const Number&) const = default;
};

constexpr std::int32_t kMostDigits = 99'999'999;
constexpr unsigned kMostPlaces = 8;

// The digits with this many places behind the point; further ones are cut, not rounded (S5-FM-38).
std::int64_t scaled(std::int64_t digits, unsigned places, unsigned wanted);
inline std::int64_t scaled(Number n, unsigned wanted) { return scaled(n.digits, n.places, wanted); }

// Nothing if these are more than eight digits.
std::optional<Number> makeNumber(std::int64_t digits, unsigned places);
std::optional<Number> sum(Number a, Number b);

}  // namespace merker::nc
