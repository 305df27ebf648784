// BCD values of the PLC: nibble 9 is the sign (0 positive, 1 negative), nibbles 8 … 0 are digits,
// the highest first, and E at the place of the decimal point (S5-FM-37).
#pragma once

#include <cstdint>
#include <optional>

#include "nc/number.h"

namespace merker::nc {

// Nine digits and E of `value`; the lowest nibble is the last digit.
std::uint64_t bcdNibbles(std::uint64_t digits, unsigned places, bool point);

struct Bcd {
  std::int64_t digits = 0;
  std::optional<unsigned> places;  // behind an E
};
// `nibbles` with the sign in nibble 9. Nothing if a digit or the sign is none.
std::optional<Bcd> parseBcd(std::uint64_t nibbles);

}  // namespace merker::nc
