#include "cpu/interrupts.h"

#include <gtest/gtest.h>

#include "address/constant.h"

namespace merker::cpu {
namespace {

std::int64_t day(int year, int month, int date) {
  return *daysSince1990(year, month, date) * 86'400'000LL;
}

// S7-OBI-03, S7-SFC-12
TEST(TimeOfDay, FindsTheNextTime) {
  const std::int64_t start = day(2005, 1, 31) + 3'600'000;
  EXPECT_EQ(nextTimeOfDay(start, Period::Once, start - 1), start);
  EXPECT_EQ(nextTimeOfDay(start, Period::Once, start), -1);
  EXPECT_EQ(nextTimeOfDay(start, Period::Minute, start), start + 60'000);
  EXPECT_EQ(nextTimeOfDay(start, Period::Hour, start + 1), start + 3'600'000);
  EXPECT_EQ(nextTimeOfDay(start, Period::Week, start), start + 7 * 86'400'000LL);
  constexpr std::int64_t kLast = 36'525 * 86'400'000LL - 1;  // of 2089
  EXPECT_EQ(nextTimeOfDay(start, Period::Minute, kLast), -1);
  EXPECT_EQ(nextTimeOfDay(start, Period::Month, start),
            day(2005, 3, 31) + 3'600'000);  // February has no 31st
  EXPECT_EQ(nextTimeOfDay(start, Period::EndOfMonth, start), day(2005, 2, 28) + 3'600'000);
  EXPECT_EQ(nextTimeOfDay(day(2004, 2, 29), Period::Year, day(2004, 2, 29)), day(2008, 2, 29));
}

// S7-OBI-03, S7-SFC-12: before the start, at a time itself, long behind it, across ends of months
// and years.
TEST(TimeOfDay, KeepsDayAndTime) {
  constexpr std::int64_t kHour = 3'600'000, kDay = 24 * kHour;
  const std::int64_t start = day(2005, 1, 31) + 5 * kHour;
  for (const Period period : {Period::Minute, Period::Hour, Period::Day, Period::Week,
                              Period::Month, Period::Year, Period::EndOfMonth})
    EXPECT_EQ(nextTimeOfDay(start, period, start - 1), start) << static_cast<int>(period);
  EXPECT_EQ(nextTimeOfDay(start, Period::Minute, start + 59'999), start + 60'000);
  EXPECT_EQ(nextTimeOfDay(start, Period::Minute, start + 60'000), start + 120'000);
  EXPECT_EQ(nextTimeOfDay(start, Period::Hour, start + 100 * kHour), start + 101 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::Day, start), start + kDay);
  EXPECT_EQ(nextTimeOfDay(start, Period::Day, start + 10 * kDay - 1), start + 10 * kDay);
  EXPECT_EQ(nextTimeOfDay(start, Period::Week, start + 7 * kDay), start + 14 * kDay);
  EXPECT_EQ(nextTimeOfDay(start, Period::Month, day(2005, 3, 31) + 5 * kHour),
            day(2005, 5, 31) + 5 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::Month, day(2005, 12, 31) + 5 * kHour),
            day(2006, 1, 31) + 5 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::Year, day(2005, 12, 31)), day(2006, 1, 31) + 5 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::EndOfMonth, day(2007, 2, 28)),
            day(2007, 2, 28) + 5 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::EndOfMonth, day(2008, 2, 28) + 6 * kHour),
            day(2008, 2, 29) + 5 * kHour);
  EXPECT_EQ(nextTimeOfDay(start, Period::EndOfMonth, day(2005, 4, 30) + 5 * kHour),
            day(2005, 5, 31) + 5 * kHour);
  const std::int64_t thirtieth = day(2005, 4, 30);
  EXPECT_EQ(nextTimeOfDay(thirtieth, Period::EndOfMonth, thirtieth), day(2005, 5, 31));
  EXPECT_EQ(nextTimeOfDay(thirtieth, Period::Month, thirtieth), day(2005, 5, 30));
  EXPECT_EQ(nextTimeOfDay(day(2004, 2, 29), Period::Year, day(2004, 3, 1)), day(2008, 2, 29));
}

TEST(TimeOfDay, MovesOnOrExpires) {
  TimeOfDayInterrupt once{.set = true, .active = true, .start = 1000};
  once.moveOn(999);
  EXPECT_TRUE(once.active && !once.expired);
  EXPECT_EQ(once.due, 1000);
  once.moveOn(1000);
  EXPECT_TRUE(!once.active && once.expired);
}

TEST(TimeOfDay, KnowsItsPeriods) {
  for (const std::uint32_t word :
       {0x0000u, 0x0201u, 0x0401u, 0x1001u, 0x1201u, 0x1401u, 0x1801u, 0x2001u})
    EXPECT_TRUE(isPeriod(word)) << word;
  for (const std::uint32_t word : {0x0001u, 0x0200u, 0x0202u, 0x1601u, 0x2000u, 0x2201u})
    EXPECT_FALSE(isPeriod(word)) << word;
}

// S7-BLK-10
TEST(CyclicInterrupts, HaveDefaultIntervals) {
  constexpr std::int32_t kMilliseconds[] = {5000, 2000, 1000, 500, 200, 100, 50, 20, 10};
  for (std::uint8_t i = 0; i < 9; ++i)
    EXPECT_EQ(defaultInterval(static_cast<std::uint8_t>(30 + i)), kMilliseconds[i]);
  EXPECT_EQ(defaultInterval(29), 0);
  EXPECT_EQ(defaultInterval(39), 0);
}

}  // namespace
}  // namespace merker::cpu
