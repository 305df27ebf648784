// Floating point numbers of STEP 5 (S5-NUM-04).
#include <gtest/gtest.h>

#include <cmath>

#include "mc5/s5_float.h"

namespace merker::mc5 {
namespace {

// S5-NUM-04
TEST(S5Float, KnownNumbers) {
  EXPECT_EQ(fromDouble(1.0).bits, 0x01400000u);
  EXPECT_EQ(fromDouble(12.5).bits, 0x04640000u);
  EXPECT_EQ(fromDouble(0.0).bits, 0x80000000u);
  EXPECT_EQ(fromDouble(-1.0).bits, 0x01C00000u);
  EXPECT_EQ(toDouble(0x01C00000), -1.0);
  EXPECT_EQ(toDouble(0x00800000), -1.0);  // the other spelling, OP-49
  EXPECT_EQ(toDouble(0x80000000), 0.0);
}

TEST(S5Float, LimitsOfTheFormat) {
  EXPECT_EQ(fromDouble(std::ldexp(0.5, -128)).bits, 0x80400000u);  // 2^-129, the smallest
  EXPECT_EQ(fromDouble(std::ldexp(0.5, -129)).range, FloatRange::Underflow);
  EXPECT_EQ(fromDouble(std::ldexp(0.5, -129)).bits, 0x80000000u);
  EXPECT_EQ(fromDouble(std::ldexp(0.5, 127)).bits, 0x7F400000u);
  EXPECT_EQ(fromDouble(std::ldexp(1.0, 127)).range, FloatRange::Overflow);
  EXPECT_EQ(fromDouble(-std::ldexp(1.0, 127)).range, FloatRange::Overflow);
  EXPECT_EQ(fromDouble(std::ldexp(1.0 - std::ldexp(1.0, -26), 1)).bits, 0x02400000u);  // rounds up
}

TEST(S5Float, NormalisedNumbersComeBack) {
  for (std::uint32_t exponent = 0; exponent < 256; exponent += 5)
    for (const std::uint32_t mantissa : {0x400000u, 0x400001u, 0x7FFFFFu, 0xC00000u, 0x800001u}) {
      const std::uint32_t bits = exponent << 24 | mantissa;
      EXPECT_EQ(fromDouble(toDouble(bits)).bits, bits) << std::hex << bits;
    }
}

}  // namespace
}  // namespace merker::mc5
