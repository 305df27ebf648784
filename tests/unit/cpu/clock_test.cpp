#include <gtest/gtest.h>

#include "address/constant.h"
#include "cpu/real_time_clock.h"

namespace merker::cpu {
namespace {

// S7-TYPES-18: DT#1998-04-14-17:53:17.333 is a Tuesday.
TEST(RealTimeClock, ShowsDateAndTime) {
  const std::int64_t days = *daysSince1990(1998, 4, 14);
  const std::int64_t time = ((17 * 60 + 53) * 60 + 17) * 1000 + 333;
  const DateAndTime dt = toDateAndTime(days * 86'400'000 + time);
  const DateAndTime expected{0x98, 0x04, 0x14, 0x17, 0x53, 0x17, 0x33, 0x33};
  EXPECT_EQ(dt, expected);
  EXPECT_EQ(fromDateAndTime(dt.data()), days * 86'400'000 + time);
}

TEST(RealTimeClock, RefusesWhatIsNoDate) {
  const DateAndTime wrong[] = {
      {0x98, 0x13, 0x14}, {0x98, 0x04, 0x31}, {0x98, 0x04, 0x14, 0x24}, {0x9A, 0x01, 0x01}};
  for (const DateAndTime& dt : wrong) EXPECT_FALSE(fromDateAndTime(dt.data()));
}

// S7-TYPES-18: the first and the last of each field; years 90 to 99 are 19xx, 00 to 89 are 20xx.
TEST(RealTimeClock, EndsOfTheFields) {
  const DateAndTime good[] = {{0x90, 0x01, 0x01},
                              {0x99, 0x12, 0x31},
                              {0x00, 0x01, 0x01},
                              {0x89, 0x12, 0x31, 0x23, 0x59, 0x59, 0x99, 0x97},
                              {0x04, 0x02, 0x29}};
  for (const DateAndTime& dt : good) EXPECT_TRUE(fromDateAndTime(dt.data()));
  EXPECT_EQ(fromDateAndTime(good[0].data()), 0);
  EXPECT_EQ(fromDateAndTime(good[2].data()), 3652 * 86'400'000LL);
  EXPECT_EQ(fromDateAndTime(good[3].data()), 36'525 * 86'400'000LL - 1);
  const DateAndTime wrong[] = {{0x90, 0x00, 0x01},
                               {0x90, 0x01, 0x00},
                               {0x90, 0x01, 0x32},
                               {0x05, 0x02, 0x29},
                               {0x90, 0x01, 0x01, 0x00, 0x60},
                               {0x90, 0x01, 0x01, 0x00, 0x00, 0x60},
                               {0x90, 0x01, 0x01, 0x00, 0x00, 0x00, 0x9A},
                               {0x90, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0xA0}};
  for (const DateAndTime& dt : wrong) EXPECT_FALSE(fromDateAndTime(dt.data()));
  const DateAndTime last{0x89, 0x12, 0x31, 0x23, 0x59, 0x59, 0x99, 0x97};
  EXPECT_EQ(toDateAndTime(36'525 * 86'400'000LL - 1), last);
  EXPECT_EQ(toDateAndTime(-1), last);  // DT has no year before 1990
  EXPECT_EQ(toDateAndTime(36'525 * 86'400'000LL), toDateAndTime(0));
}

TEST(RealTimeClock, RunsWithVirtualTime) {
  RealTimeClock clock(1000);
  EXPECT_EQ(clock.milliseconds(Instant{} + Duration::seconds(2)), 3000);
  clock.set(50'000, Instant{} + Duration::seconds(2));
  EXPECT_EQ(clock.milliseconds(Instant{} + Duration::seconds(3)), 51'000);
  EXPECT_EQ(clock.when(51'000, Instant{}), Instant{} + Duration::seconds(3));
}

// S7-CPU-32: behind 2089 there is no year that DATE_AND_TIME could show.
TEST(RealTimeClock, BeginsAgainBehindItsLastYear) {
  const std::int64_t last = 36'525 * 86'400'000LL - 1;
  RealTimeClock clock(0);
  clock.set(last, Instant{} + Duration::seconds(5));
  EXPECT_EQ(clock.milliseconds(Instant{} + Duration::seconds(5)), last);
  const Instant later = Instant{} + Duration::milliseconds(5001);
  EXPECT_EQ(clock.milliseconds(later), 0);
  EXPECT_EQ(clock.when(1'000, later), later + Duration::seconds(1));
}

}  // namespace
}  // namespace merker::cpu
