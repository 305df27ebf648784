// Days, weekdays and the S5TIME word.
#include <chrono>

#include "address/constant.h"
#include "base/bcd.h"

namespace merker {
namespace {

using std::chrono::sys_days;
using std::chrono::year_month_day;

constexpr sys_days kFirst{
    year_month_day{std::chrono::year{1990}, std::chrono::January, std::chrono::day{1}}};

}  // namespace

std::optional<std::uint16_t> daysSince1990(int year, int month, int day) {
  if (year < 1990 || year > 2168 || month < 1 || day < 1) return std::nullopt;
  const year_month_day date{std::chrono::year{year},
                            std::chrono::month{static_cast<unsigned>(month)},
                            std::chrono::day{static_cast<unsigned>(day)}};
  if (month > 12 || day > 31 || !date.ok()) return std::nullopt;
  return static_cast<std::uint16_t>((sys_days{date} - kFirst).count());
}

void dateFromDays(std::uint16_t days, int& year, int& month, int& day) {
  const year_month_day date{kFirst + std::chrono::days{days}};
  year = static_cast<int>(date.year());
  month = static_cast<int>(static_cast<unsigned>(date.month()));
  day = static_cast<int>(static_cast<unsigned>(date.day()));
}

// 1990-01-01 was a Monday.
int weekday(std::uint16_t days) { return (days + 1) % 7 + 1; }

std::optional<std::uint16_t> encodeS5Time(std::uint64_t milliseconds) {
  if (milliseconds > 9'990'000) return std::nullopt;
  std::uint32_t base = 0;
  auto count = static_cast<std::uint32_t>(milliseconds / 10);
  for (; count > 999; count /= 10) ++base;
  return static_cast<std::uint16_t>(base << 12 | toBcd(count, 3));
}

std::optional<std::uint32_t> decodeS5Time(std::uint16_t s5time) {
  const auto count = fromBcd(s5time, 3);
  if (!count) return std::nullopt;
  constexpr std::uint32_t kBase[] = {10, 100, 1000, 10000};
  return *count * kBase[s5time >> 12 & 3];
}

}  // namespace merker
