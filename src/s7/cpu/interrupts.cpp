#include "cpu/interrupts.h"

#include <algorithm>

#include "address/constant.h"
#include "cpu/real_time_clock.h"

namespace merker::cpu {
namespace {

constexpr std::int64_t kDay = 86'400'000;

struct Date {
  int year, month, day;
};

Date dateOf(std::int64_t milliseconds) {
  Date date{};
  dateFromDays(static_cast<std::uint16_t>(milliseconds / kDay), date.year, date.month, date.day);
  return date;
}

std::int64_t lengthOf(Period period) {
  switch (period) {
    case Period::Minute:
      return 60'000;
    case Period::Hour:
      return 3'600'000;
    case Period::Day:
      return kDay;
    case Period::Week:
      return 7 * kDay;
    default:
      return 0;
  }
}

// The same day and time `months` later, or the last day of that month; -1 if that month has no such
// day.
std::int64_t monthsLater(std::int64_t start, int months, bool last) {
  const Date date = dateOf(start);
  const int count = date.month - 1 + months;
  const int year = date.year + count / 12, month = count % 12 + 1;
  std::optional<std::uint16_t> days;
  for (int day = last ? 31 : date.day; !days && day >= (last ? 28 : date.day); --day)
    days = daysSince1990(year, month, day);
  return days ? *days * kDay + start % kDay : -1;
}

std::int64_t next(std::int64_t start, Period period, std::int64_t now) {
  if (period == Period::Once) return start > now ? start : -1;
  if (const std::int64_t length = lengthOf(period); length != 0)
    return start > now ? start : start + ((now - start) / length + 1) * length;
  const int step = period == Period::Year ? 12 : 1;
  constexpr int kMonthsOfDt = 1200;  // DT reaches over 100 years
  for (int months = 0; months < kMonthsOfDt; months += step) {
    const std::int64_t due = monthsLater(start, months, period == Period::EndOfMonth);
    if (due > now && due >= start) return due;
  }
  return -1;
}

}  // namespace

void TimeOfDayInterrupt::moveOn(std::int64_t now) {
  due = nextTimeOfDay(start, period, now);
  active = due >= 0;
  expired = !active;
}

DelayInterrupt* Interrupts::findDelay(std::uint32_t ob) {
  const auto at =
      std::find_if(delay.begin(), delay.end(), [&](const auto& d) { return d.ob == ob; });
  return at == delay.end() ? nullptr : &*at;
}

TimeOfDayInterrupt* Interrupts::findTimeOfDay(std::uint32_t ob) {
  const auto at =
      std::find_if(timeOfDay.begin(), timeOfDay.end(), [&](const auto& d) { return d.ob == ob; });
  return at == timeOfDay.end() ? nullptr : &*at;
}

bool Interrupts::isLocked(std::uint8_t ob) const {
  return std::find(locked.begin(), locked.end(), ob) != locked.end();
}

// Later than the clock ever shows: it is not due any more.
std::int64_t nextTimeOfDay(std::int64_t start, Period period, std::int64_t now) {
  const std::int64_t due = next(start, period, now);
  return due < kYearsOfClock ? due : -1;
}

bool isPeriod(std::uint32_t word) {
  constexpr Period kPeriods[] = {Period::Once, Period::Minute, Period::Hour, Period::Day,
                                 Period::Week, Period::Month,  Period::Year, Period::EndOfMonth};
  return std::any_of(std::begin(kPeriods), std::end(kPeriods),
                     [&](Period p) { return static_cast<std::uint32_t>(p) == word; });
}

std::int32_t defaultInterval(std::uint8_t ob) {
  constexpr std::int32_t kMilliseconds[] = {5000, 2000, 1000, 500, 200, 100, 50, 20, 10};
  return ob >= 30 && ob <= 38 ? kMilliseconds[ob - 30] : 0;
}

}  // namespace merker::cpu
