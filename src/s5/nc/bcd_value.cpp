#include "nc/bcd_value.h"

namespace merker::nc {
namespace {

constexpr unsigned kPoint = 0xE, kNibbles = 9;

unsigned nibble(std::uint64_t nibbles, unsigned index) { return nibbles >> 4 * index & 0xF; }

}  // namespace

std::uint64_t bcdNibbles(std::uint64_t digits, unsigned places, bool point) {
  std::uint64_t result = 0;
  for (unsigned i = 0; i < kNibbles; ++i) {
    const bool here = point && i == places;
    result |= (here ? std::uint64_t{kPoint} : digits % 10) << 4 * i;
    if (!here) digits /= 10;
  }
  return result;
}

std::optional<Bcd> parseBcd(std::uint64_t nibbles) {
  Bcd result;
  for (unsigned i = kNibbles; i-- > 0;) {
    const unsigned digit = nibble(nibbles, i);
    if (digit == kPoint && !result.places)
      result.places = i;
    else if (digit > 9)
      return std::nullopt;
    else
      result.digits = result.digits * 10 + digit;
  }
  const unsigned sign = nibble(nibbles, kNibbles);
  if (sign > 1) return std::nullopt;
  if (sign == 1) result.digits = -result.digits;
  return result;
}

}  // namespace merker::nc
