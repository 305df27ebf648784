#include "mc5/s5_float.h"

#include <cmath>

namespace merker::mc5 {
namespace {

constexpr int kMantissaBits = 23;
constexpr std::int32_t kLargestMantissa = (1 << kMantissaBits) - 1;
constexpr int kLargestExponent = 127, kSmallestExponent = -128;

std::uint32_t compose(int exponent, std::int32_t mantissa) {
  return static_cast<std::uint32_t>(exponent) << 24 |
         (static_cast<std::uint32_t>(mantissa) & 0xFFFFFF);
}

}  // namespace

double toDouble(std::uint32_t bits) {
  const auto exponent = static_cast<std::int8_t>(bits >> 24);
  const auto mantissa = static_cast<std::int32_t>(bits << 8) >> 8;  // bit 23 is the sign
  return std::ldexp(static_cast<double>(mantissa), exponent - kMantissaBits);
}

FloatResult fromDouble(double value) {
  if (value == 0) return {};
  int exponent = 0;
  auto mantissa = static_cast<std::int32_t>(
      std::nearbyint(std::ldexp(std::frexp(value, &exponent), kMantissaBits)));
  if (mantissa > kLargestMantissa || mantissa < -kLargestMantissa) {  // rounded up to 1.0
    mantissa /= 2;
    ++exponent;
  }
  if (exponent < kSmallestExponent) return {kFloatZero, FloatRange::Underflow};
  if (exponent > kLargestExponent)
    return {compose(kLargestExponent, value > 0 ? kLargestMantissa : -kLargestMantissa),
            FloatRange::Overflow};
  return {compose(exponent, mantissa), FloatRange::Fits};
}

}  // namespace merker::mc5
