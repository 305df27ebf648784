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
  EXPECT_EQ(nextTimeOfDay(start, Period::Month, start),
            day(2005, 3, 31) + 3'600'000);  // February has no 31st
  EXPECT_EQ(nextTimeOfDay(start, Period::EndOfMonth, start), day(2005, 2, 28) + 3'600'000);
  EXPECT_EQ(nextTimeOfDay(day(2004, 2, 29), Period::Year, day(2004, 2, 29)), day(2008, 2, 29));
}

// S7-BLK-10
TEST(CyclicInterrupts, HaveDefaultIntervals) {
  EXPECT_EQ(defaultInterval(30), 5000);
  EXPECT_EQ(defaultInterval(35), 100);
  EXPECT_EQ(defaultInterval(38), 10);
  EXPECT_EQ(defaultInterval(39), 0);
}

}  // namespace
}  // namespace merker::cpu
