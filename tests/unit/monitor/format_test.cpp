#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

using enum DisplayFormat;

struct Row {
  const char* operand;
  std::uint32_t bits;
  DisplayFormat format;
  const char* text;
};

address::Reference reference(const char* operand) {
  static const Plc plc(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n NOP 0;\nEND_ORGANIZATION_BLOCK\n");
  const auto result = plc.resolver()(operand, {});
  EXPECT_TRUE(result) << operand;
  return result ? *result : address::Reference{};
}

// S7-SIM-12: one value, every format; typed in again it is the same value.
TEST(Format, ShowsAndReads) {
  constexpr Row kRows[] = {
      {"MW 0", 5, Bin, "2#0000_0000_0000_0101"},
      {"MB 0", 0xA5, Bin, "2#1010_0101"},
      {"MW 0", 0xABCD, Hex, "W#16#ABCD"},
      {"MB 0", 0x0F, Hex, "B#16#0F"},
      {"MD 0", 0xDEADBEEF, Hex, "DW#16#DEADBEEF"},
      {"MW 0", 0xFFFF, Dec, "-1"},
      {"MW 0", 0xFFFF, Unsigned, "65535"},
      {"MD 0", 0x80000001, Dec, "-2147483647"},
      {"MW 0", 0x0123, Bcd, "123"},
      {"MW 0", 0xF123, Bcd, "-123"},
      {"MB 0", 0x99, Bcd, "99"},
      {"MD 0", 0x3FC00000, Real, "1.500000e+000"},
      {"MW 0", 0x4142, Char, "'AB'"},
      {"MW 0", 0x2010, S5Time, "S5T#10S"},
      {"MD 0", 90061001, Time, "T#1D1H1M1S1MS"},
      {"MW 0", 3024, Date, "D#1998-04-13"},
      {"MD 0", 64397333, TimeOfDay, "TOD#17:53:17.333"},
      {"MW 0", 0x0128, Counter, "C#128"},
      {"MD 0", 0x83000050, Pointer, "P#M10.0"},
      {"MD 0", 0x01600000, Kg, "KG +1500000+01"},  // S5-NUM-04
      {"M 0.0", 1, Bool, "TRUE"},
      {"M 0.0", 1, Hex, "1"},
      {"M 0.0", 0, Bool, "FALSE"},
  };
  for (const Row& row : kRows) {
    const address::Reference operand = reference(row.operand);
    EXPECT_EQ(show(operand, row.bits, row.format), row.text);
    const auto again = parseValue(operand, row.text, row.format);
    ASSERT_TRUE(again) << row.text;
    if (std::string(row.text) != "S5T#10S") EXPECT_EQ(*again, row.bits) << row.text;
  }
}

// S7-SIM-12: a pattern that the format cannot express stays visible.
TEST(Format, ShowsWhatItCannotExpress) {
  EXPECT_EQ(show(reference("MW 0"), 0x0ABC, Bcd), "W#16#0ABC");
  EXPECT_EQ(show(reference("MW 0"), 0x0ABC, Counter), "W#16#0ABC");
  EXPECT_EQ(show(reference("MW 0"), 0x0005, Real), "W#16#0005");  // does not fit: as it is
}

TEST(Format, TakesPlainDigits) {
  const auto value = [](const char* operand, const char* text, DisplayFormat format) {
    const auto result = parseValue(reference(operand), text, format);
    return result ? static_cast<std::int64_t>(*result) : -1;
  };
  EXPECT_EQ(value("MW 0", "00FF", Hex), 0xFF);
  EXPECT_EQ(value("MW 0", "1010", Bin), 10);
  EXPECT_EQ(value("MW 0", "1010", Bcd), -1);  // three digits and a sign
  EXPECT_EQ(value("MW 0", "32768", Dec), -1);
  EXPECT_EQ(value("MW 0", "W#16#0010", Bcd), 0x10);
  EXPECT_EQ(value("MW 0", "-12", Bcd), 0xF012);
  EXPECT_EQ(value("MW 0", "-5", Dec), 0xFFFB);
  EXPECT_EQ(value("MD 0", "-5", Dec), 0xFFFFFFFB);
  EXPECT_EQ(value("MD 0", "2", Real), 0x40000000);
  EXPECT_EQ(value("MB 0", "300", Automatic), -1);
  EXPECT_EQ(value("MB 0", "-1", Automatic), 0xFF);
  EXPECT_EQ(value("Z 1", "128", Automatic), 0x128);
  EXPECT_EQ(value("MW 0", "hello", Hex), -1);
}

TEST(Format, HasNames) {
  for (const FormatRow& row : displayFormats()) {
    const auto format = parseFormat(row.name);
    ASSERT_TRUE(format);
    EXPECT_EQ(*format, row.format);
  }
  EXPECT_EQ(parseFormat("ROMAN").error().name(), "P1208");
  EXPECT_FALSE(fits(Real, 16));
  EXPECT_TRUE(fits(Real, 32));
}

}  // namespace
}  // namespace merker::monitor::test
