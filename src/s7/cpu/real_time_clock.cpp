#include "cpu/real_time_clock.h"

#include "address/constant.h"
#include "base/bcd.h"

namespace merker::cpu {
namespace {

constexpr std::int64_t kDay = 86'400'000;
struct Field {
  unsigned low, high;
};
constexpr Field kFields[] = {{0, 99}, {1, 12}, {1, 31}, {0, 23}, {0, 59}, {0, 59}, {0, 99}};

// Each cycle asks for the date of its beginning, which is nearly always that of the one before.
struct Day {
  std::int64_t since1990 = -1;
  std::uint8_t year = 0, month = 0, day = 0, weekday = 0;  // BCD
};
const Day& dayOf(std::int64_t since1990) {
  thread_local Day last;
  if (last.since1990 == since1990) return last;
  const auto days = static_cast<std::uint16_t>(since1990);
  int year = 0, month = 0, day = 0;
  dateFromDays(days, year, month, day);
  last = {since1990, toBcd(static_cast<unsigned>(year % 100)), toBcd(static_cast<unsigned>(month)),
          toBcd(static_cast<unsigned>(day)), static_cast<std::uint8_t>(weekday(days))};
  return last;
}

}  // namespace

DateAndTime toDateAndTime(std::int64_t milliseconds) {
  const std::int64_t shown = (milliseconds % kYearsOfClock + kYearsOfClock) % kYearsOfClock;
  const std::int64_t time = shown % kDay;
  const Day& day = dayOf(shown / kDay);
  const auto ms = static_cast<unsigned>(time % 1000);
  const auto seconds = static_cast<unsigned>(time / 1000);
  return {day.year,
          day.month,
          day.day,
          toBcd(seconds / 3600),
          toBcd(seconds / 60 % 60),
          toBcd(seconds % 60),
          toBcd(ms / 10),
          static_cast<std::uint8_t>(ms % 10 << 4 | unsigned{day.weekday})};
}

std::optional<std::int64_t> fromDateAndTime(const std::uint8_t* bytes) {
  std::int64_t part[7];
  for (int i = 0; i < 7; ++i) {
    const auto value = fromBcd(bytes[i], 2);
    if (!value || *value < kFields[i].low || *value > kFields[i].high) return std::nullopt;
    part[i] = *value;
  }
  const unsigned units = bytes[7] >> 4;
  if (units > 9) return std::nullopt;
  const int year = static_cast<int>(part[0]) + (part[0] >= 90 ? 1900 : 2000);
  const auto days = daysSince1990(year, static_cast<int>(part[1]), static_cast<int>(part[2]));
  if (!days) return std::nullopt;
  return *days * kDay + part[3] * 3'600'000 + part[4] * 60'000 + part[5] * 1'000 + part[6] * 10 +
         units;
}

}  // namespace merker::cpu
