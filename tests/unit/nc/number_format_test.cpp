// ZFPN: numbers of the NC as words of the PLC.
#include "nc/number_format.h"

#include <gtest/gtest.h>

#include "nc/bcd_value.h"

namespace merker::nc {
namespace {

using Words = std::vector<unsigned>;

Format format(const char* text) {
  return *parseFormat(static_cast<std::uint16_t>(text[0] << 8 | text[1]));
}
Words encoded(Number n, const char* as, Content content = Content::Floating,
              InputSystem system = InputSystem::Metric) {
  const auto value = encode(n, format(as), content, system);
  return value ? Words(value->words.begin(), value->words.begin() + value->count) : Words{};
}
std::optional<Number> decoded(std::vector<std::uint16_t> words, const char* as,
                              Content content = Content::Floating,
                              InputSystem system = InputSystem::Metric) {
  return decode(words, format(as), content, system);
}

constexpr Number kR100{1234567, 3};  // 1234.567

// S5-FM-36: the 28 names of table T1 and no others.
TEST(NumberFormat, Names) {
  unsigned count = 0;
  for (unsigned code = 0; code <= 0xFFFF; ++code)
    if (const auto found = parseFormat(static_cast<std::uint16_t>(code))) {
      ++count;
      EXPECT_EQ(name(*found)[0], static_cast<char>(code >> 8));
      EXPECT_EQ(name(*found)[1], static_cast<char>(code & 0xFF));
    }
  EXPECT_EQ(count, 28u);
}

// S5-FM-28: three words for BCD, two for fixed point, one for a bit pattern.
TEST(NumberFormat, Words) {
  EXPECT_EQ(wordCount(Format::B0), 3u);
  EXPECT_EQ(wordCount(Format::BG), 3u);
  EXPECT_EQ(wordCount(Format::F9), 2u);
  EXPECT_EQ(wordCount(Format::FF), 2u);
  EXPECT_EQ(wordCount(Format::BI), 1u);
}

// S5-FM-36, S5-FM-39: the manual's R100 = 1234.567 with F4, and the row of F0 … F9.
TEST(NumberFormat, FixedPoint) {
  EXPECT_EQ(encoded(kR100, "F4"), (Words{1234567 >> 16, 1234567 & 0xFFFF}));
  const std::int64_t expected[] = {1234,     1234,      12345,      123456,      1234567,
                                   12345670, 123456700, 1234567000, 12345670000, 123456700000};
  for (unsigned i = 0; i < 10; ++i) {
    const char text[] = {'F', static_cast<char>('0' + i), 0};
    const auto bits = static_cast<std::uint32_t>(expected[i]);
    const bool fits = expected[i] <= INT32_MAX;
    EXPECT_EQ(encoded(kR100, text), fits ? (Words{bits >> 16, bits & 0xFFFF}) : Words{}) << text;
  }
  EXPECT_EQ(encoded({-5, 0}, "F0"), (Words{0xFFFF, 0xFFFB}));
}

// S5-FM-39: PLC 121457 with F2 is 12145.7 in the NC. S5-FM-33: a 16-bit value stands in word k+1.
TEST(NumberFormat, FixedPointToTheNc) {
  EXPECT_EQ(decoded({1, 121457 - 65536}, "F2"), (Number{121457, 1}));
  EXPECT_EQ(decoded({0, 25}, "F0"), (Number{25, 0}));
  EXPECT_EQ(decoded({0xFFFF, 0xFFFB}, "F3"), (Number{-5, 2}));
  EXPECT_EQ(decoded({0x05F5, 0xE0FF}, "F0"), (Number{99'999'999, 0}));
  EXPECT_EQ(decoded({0x05F5, 0xE100}, "F0"), std::nullopt);
}

// S5-FM-37: R100 = -87654.321 with B4.
TEST(NumberFormat, Bcd) {
  EXPECT_EQ(encoded({-87654321, 3}, "B4"), (Words{0x18, 0x7654, 0xE321}));
  EXPECT_EQ(encoded({1234, 0}, "B0"), (Words{0x00, 0x0000, 0x1234}));
  EXPECT_EQ(encoded({1234, 0}, "B1"), (Words{0x00, 0x0001, 0x234E}));
  EXPECT_EQ(encoded(kR100, "B3"), (Words{0x00, 0x0123, 0x4E56}));
  EXPECT_EQ(encoded({5, 1}, "B9"), (Words{0x0E, 0x5000, 0x0000}));
  EXPECT_EQ(encoded({87654321, 0}, "B2"), Words{});  // nine digits
}

// S5-FM-38: 1234.56 with B2 is 1234.5; the left byte of the first word is free.
TEST(NumberFormat, BcdToTheNc) {
  EXPECT_EQ(decoded({0xFF00, 0x0012, 0x34E5}, "B2"), (Number{12345, 1}));
  EXPECT_EQ(decoded({0x0000, 0x0123, 0x4E56}, "B2"), (Number{12345, 1}));
  EXPECT_EQ(decoded({0x0018, 0x7654, 0xE321}, "B4"), (Number{-87654321, 3}));
  EXPECT_EQ(decoded({0, 0, 0x1234}, "B0"), (Number{1234, 0}));
  EXPECT_EQ(decoded({0, 0, 0x1234}, "B3"), (Number{123400, 2}));
  EXPECT_EQ(decoded({0, 0, 0x123A}, "B3"), std::nullopt);
  EXPECT_EQ(decoded({0, 0x000E, 0x12E4}, "B3"), std::nullopt);  // two points
  EXPECT_EQ(decoded({0x20, 0, 0}, "B3"), std::nullopt);         // sign 2
  EXPECT_EQ(decoded({0x01, 0x2345, 0x6789}, "B0"), std::nullopt);
}

// S5-FM-36: BG is the value as it is stored, in both directions.
TEST(NumberFormat, AsStored) {
  EXPECT_EQ(encoded(kR100, "BG"), (Words{0x00, 0x1234, 0xE567}));
  EXPECT_EQ(decoded({0x00, 0x1234, 0xE567}, "BG"), kR100);
  EXPECT_EQ(encoded({25, 0}, "BG"), (Words{0, 0, 0x025E}));
}

// S5-FM-40: R100 = 10111010.
TEST(NumberFormat, BitPattern) {
  EXPECT_EQ(encoded({10111010, 0}, "BI"), (Words{0xBA}));
  EXPECT_EQ(encoded({10111020, 0}, "BI"), Words{});
  EXPECT_EQ(encoded({-1, 0}, "BI"), Words{});
  EXPECT_EQ(encoded({11, 1}, "BI"), Words{});
  EXPECT_EQ(decoded({0xBA}, "BI"), (Number{10111010, 0}));
  EXPECT_EQ(decoded({0x1BA}, "BI"), std::nullopt);
  EXPECT_EQ(encoded({0xBA, 0}, "BI", Content::Bits), (Words{0xBA}));
  EXPECT_EQ(decoded({0xBA}, "BI", Content::Bits), (Number{0xBA, 0}));
  EXPECT_EQ(decoded({0x100}, "BI", Content::Bits), std::nullopt);
}

// S5-FM-41: the input system moves the point and nothing else.
TEST(NumberFormat, PointOfTheInputSystem) {
  const struct {
    const char* name;
    unsigned metric, inch;
  } rows[] = {{"FA", 3, 4}, {"FB", 3, 3}, {"FC", 2, 3}, {"FD", 2, 2}, {"FE", 3, 4}, {"FF", 0, 0}};
  for (const auto& row : rows) {
    const auto floating = Content::Floating;
    EXPECT_EQ(decoded({1, 0}, row.name, floating, InputSystem::Metric),
              (Number{65536, static_cast<std::uint8_t>(row.metric)}));
    EXPECT_EQ(decoded({1, 0}, row.name, floating, InputSystem::Inch),
              (Number{65536, static_cast<std::uint8_t>(row.inch)}));
  }
  EXPECT_EQ(encoded({15, 1}, "FA"), (Words{0, 1500}));
}

// S5-FM-36: without a point a position is its count in the input resolution.
TEST(NumberFormat, CountsOfPositions) {
  EXPECT_EQ(encoded({12345, 3}, "F0", Content::Position), (Words{0, 12345}));
  EXPECT_EQ(decoded({0, 12345}, "F0", Content::Position, InputSystem::Inch), (Number{12345, 4}));
  EXPECT_EQ(decoded({0, 0, 0x1234}, "B0", Content::Position), (Number{1234, 3}));
}

}  // namespace
}  // namespace merker::nc
