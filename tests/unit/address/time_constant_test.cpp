#include <gtest/gtest.h>

#include "address/constant.h"

namespace merker {
namespace {

std::uint32_t bits(std::string_view text) {
  const auto constant = parseConstant(text, {});
  EXPECT_TRUE(constant) << (constant ? "" : constant.error().message);
  return constant ? constant->bits : 0xDEADBEEF;
}

std::string_view problem(std::string_view text) {
  const auto constant = parseConstant(text, {});
  return constant ? "accepted" : constant.error().name();
}

// S7-TYPES-10: smallest base, remainder truncated.
TEST(S5Time, smallestBase) {
  EXPECT_EQ(bits("S5T#5S"), 0x0500u);
  EXPECT_EQ(bits("S5T#10S"), 0x1100u);
  EXPECT_EQ(bits("S5T#3M20S"), 0x2200u);
  EXPECT_EQ(bits("S5T#2H46M30S"), 0x3999u);
  EXPECT_EQ(bits("S5T#10MS"), 0x0001u);
  EXPECT_EQ(bits("S5T#9S990MS"), 0x0999u);
  EXPECT_EQ(bits("S5T#99S900MS"), 0x1999u);
  EXPECT_EQ(bits("S5T#16M39S"), 0x2999u);
}

TEST(S5Time, truncatesWhatTheBaseCannotHold) {
  EXPECT_EQ(bits("S5T#15MS"), 0x0001u);
  EXPECT_EQ(bits("S5T#9S999MS"), 0x0999u);
  EXPECT_EQ(bits("S5T#10S90MS"), 0x1100u);
  EXPECT_EQ(bits("S5T#2H46M29S"), 0x3998u);
}

// S7-LOAD-13, S7-OPEN-25
TEST(S5Time, limits) {
  EXPECT_EQ(problem("S5T#2H46M31S"), "P0202");
  EXPECT_EQ(problem("S5T#2H46M30S1MS"), "P0202");
  EXPECT_EQ(problem("S5T#9MS"), "P0202");
  EXPECT_EQ(problem("S5T#-1S"), "P0202");
  EXPECT_EQ(problem("S5T#99999999999999999999H"), "P0202");
  EXPECT_EQ(bits("S5T#0MS"), 0u);
}

TEST(S5Time, spellings) {
  EXPECT_EQ(bits("s5time#1h_10m_20s"), 0x3422u);
  EXPECT_EQ(bits("S5T# 100S"), 0x2100u);
}

TEST(S5Time, unitsOnceAndInOrder) {
  EXPECT_EQ(problem("S5T#1D"), "P0206");
  EXPECT_EQ(problem("S5T#20S1M"), "P0207");
  EXPECT_EQ(problem("S5T#1S1S"), "P0207");
  EXPECT_EQ(problem("S5T#"), "P0205");
  EXPECT_EQ(problem("S5T#5"), "P0205");
  EXPECT_EQ(problem("S5T#S"), "P0205");
  EXPECT_EQ(problem("S5T#1.5S"), "P0205");
}

TEST(S5Time, encodeAndDecode) {
  EXPECT_EQ(encodeS5Time(9'990'000), 0x3999);
  EXPECT_EQ(encodeS5Time(9'990'001), std::nullopt);
  EXPECT_EQ(encodeS5Time(9), 0);
  EXPECT_EQ(decodeS5Time(0x3422), 4'220'000u);
  EXPECT_EQ(decodeS5Time(0x0A00), std::nullopt);
}

// S7-TYPES-15, S7-LOAD-14
TEST(Time, limits) {
  EXPECT_EQ(bits("T#24D20H31M23S647MS"), 0x7FFFFFFFu);
  EXPECT_EQ(bits("T#-24D20H31M23S648MS"), 0x80000000u);
  EXPECT_EQ(problem("T#24D20H31M23S648MS"), "P0202");
  EXPECT_EQ(problem("T#-24D20H31M23S649MS"), "P0202");
  EXPECT_EQ(bits("TIME#-1MS"), 0xFFFFFFFFu);
  EXPECT_EQ(bits("t#1d_2h"), 93'600'000u);
}

// S7-OPEN-27: the units are D, H, M, S and MS in both mnemonics.
TEST(Time, germanUnitsAreRefused) {
  EXPECT_EQ(parseConstant("T#2T", {}).error().message,
            "T#2T: T is not a valid unit; units of TIME are D, H, M, S, MS");
  EXPECT_EQ(problem("T#5MS1S"), "P0207");
}

// S7-TYPES-11: real lengths of months, 1990-01-01 to 2168-12-31.
TEST(Date, limits) {
  EXPECT_EQ(bits("D#1990-01-01"), 0u);
  EXPECT_EQ(bits("DATE#1990-1-2"), 1u);
  EXPECT_EQ(bits("D#2000-02-29"), 3711u);
  EXPECT_EQ(bits("D#2168-12-31"), 65378u);
  EXPECT_EQ(bits("D#90-1-1"), 0u);
  EXPECT_EQ(bits("D#00-1-1"), 3652u);
  EXPECT_EQ(problem("D#1989-12-31"), "P0202");
  EXPECT_EQ(problem("D#2169-01-01"), "P0202");
  EXPECT_EQ(problem("D#1999-02-29"), "P0208");
  EXPECT_EQ(problem("D#2100-02-29"), "P0208");
  EXPECT_EQ(problem("D#1998-13-01"), "P0208");
  EXPECT_EQ(problem("D#1998-00-01"), "P0208");
  EXPECT_EQ(problem("D#1998-04-31"), "P0208");
  EXPECT_EQ(problem("D#1998-04-00"), "P0208");
  EXPECT_EQ(problem("D#1998-04"), "P0205");
  EXPECT_EQ(problem("D#199-04-01"), "P0205");
}

// S7-OPEN-26: a point stands before the milliseconds.
TEST(TimeOfDay, colonFormGetsAHint) {
  EXPECT_EQ(parseConstant("TOD#17:53:17:333", {}).error().message,
            "TOD#17:53:17:333: milliseconds must follow a point, not a colon: TOD#17:53:17.333");
}

// S7-TYPES-16
TEST(TimeOfDay, limits) {
  EXPECT_EQ(bits("TOD#0:0:0.0"), 0u);
  EXPECT_EQ(bits("TIME_OF_DAY#23:59:59.999"), 86'399'999u);
  EXPECT_EQ(bits("TOD#0:0:1.5"), 1500u);
  EXPECT_EQ(bits("TOD#0:0:1.05"), 1050u);
  EXPECT_EQ(problem("TOD#24:0:0"), "P0202");
  EXPECT_EQ(problem("TOD#0:60:0"), "P0202");
  EXPECT_EQ(problem("TOD#0:0:60"), "P0202");
  EXPECT_EQ(problem("TOD#0:0"), "P0205");
  EXPECT_EQ(problem("TOD#0:0:0.1234"), "P0205");
  EXPECT_EQ(problem("TOD#0:0:0."), "P0205");
}

// S7-TYPES-18: 98 04 14 17 53 17 33 33, Tuesday = 3.
TEST(DateAndTime, workedExample) {
  const auto value = parseDateAndTime("DT#1998-04-14-17:53:17.333", {});
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 0x9804141753173333u);
  EXPECT_EQ(formatDateAndTime(*value), "DT#1998-04-14-17:53:17.333");
}

TEST(DateAndTime, spellingsAndLimits) {
  EXPECT_EQ(*parseDateAndTime("date_and_time#90-1-1-0:0:0.000", {}), 0x9001010000000002u);
  EXPECT_EQ(*parseDateAndTime("DT#2089-12-31-23:59:59.999", {}), 0x8912312359599997u);
  EXPECT_EQ(parseDateAndTime("DT#2090-01-01-0:0:0", {}).error().name(), "P0202");
  EXPECT_EQ(parseDateAndTime("DT#1998-02-30-0:0:0", {}).error().name(), "P0208");
  EXPECT_EQ(parseDateAndTime("DT#1998-04-14-24:0:0", {}).error().name(), "P0202");
  EXPECT_EQ(parseDateAndTime("DT#1998-04-14", {}).error().name(), "P0205");
  EXPECT_EQ(parseDateAndTime("D#1998-04-14", {}).error().name(), "P0205");
  EXPECT_EQ(formatDateAndTime(0xFF00000000000000u), "16#FF00000000000000");
}

TEST(Calendar, everyDayThereAndBack) {
  for (unsigned days = 0; days <= 65378; ++days) {
    int year = 0, month = 0, day = 0;
    dateFromDays(static_cast<std::uint16_t>(days), year, month, day);
    ASSERT_EQ(daysSince1990(year, month, day), days);
  }
}

TEST(Calendar, weekday) {
  EXPECT_EQ(weekday(0), 2);                            // Monday
  EXPECT_EQ(weekday(*daysSince1990(1998, 4, 14)), 3);  // Tuesday
  EXPECT_EQ(weekday(*daysSince1990(2000, 1, 1)), 7);   // Saturday
  EXPECT_EQ(weekday(*daysSince1990(2024, 2, 25)), 1);  // Sunday
}

}  // namespace
}  // namespace merker
