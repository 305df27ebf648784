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

TEST(RealTimeClock, RunsWithVirtualTime) {
  RealTimeClock clock(1000);
  EXPECT_EQ(clock.milliseconds(Instant{} + Duration::seconds(2)), 3000);
  clock.set(50'000, Instant{} + Duration::seconds(2));
  EXPECT_EQ(clock.milliseconds(Instant{} + Duration::seconds(3)), 51'000);
  EXPECT_EQ(clock.when(51'000), Instant{} + Duration::seconds(3));
}

}  // namespace
}  // namespace merker::cpu
