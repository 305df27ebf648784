// Days, weekdays and the S5TIME word.
#include "address/constant.h"
#include "base/bcd.h"

namespace merker {
namespace {

bool isLeapYear(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int daysOfMonth(int year, int month) {
  constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return kDays[month - 1] + (month == 2 && isLeapYear(year) ? 1 : 0);
}

int daysOfYear(int year) { return isLeapYear(year) ? 366 : 365; }

}  // namespace

std::optional<std::uint16_t> daysSince1990(int year, int month, int day) {
  if (year < 1990 || year > 2168 || month < 1 || month > 12) return std::nullopt;
  if (day < 1 || day > daysOfMonth(year, month)) return std::nullopt;
  int days = day - 1;
  for (int y = 1990; y < year; ++y) days += daysOfYear(y);
  for (int m = 1; m < month; ++m) days += daysOfMonth(year, m);
  return static_cast<std::uint16_t>(days);
}

void dateFromDays(std::uint16_t days, int& year, int& month, int& day) {
  int rest = days;
  for (year = 1990; rest >= daysOfYear(year); ++year) rest -= daysOfYear(year);
  for (month = 1; rest >= daysOfMonth(year, month); ++month) rest -= daysOfMonth(year, month);
  day = rest + 1;
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
