// Floating point numbers of STEP 5 (S5-NUM-04): bits 31..24 exponent to base 2 in two's complement,
// bits 23..0 mantissa in two's complement, 0.5 <= |m| < 1; value = m * 2^exponent. Zero is
// 16#80000000.
#pragma once

#include <cstdint>

namespace merker::mc5 {

constexpr std::uint32_t kFloatZero = 0x80000000;

// Where a result lies, as the displays show it (S5-STAT-T1).
enum class FloatRange : std::uint8_t { Fits, Underflow, Overflow };

struct FloatResult {
  std::uint32_t bits = kFloatZero;
  FloatRange range = FloatRange::Fits;
};

// Exact: a double holds every number of this format, normalised or not.
double toDouble(std::uint32_t bits);
// The nearest number of the format. Underflow gives zero; overflow the greatest of its sign.
FloatResult fromDouble(double value);

}  // namespace merker::mc5
