// FC 1 AD_DT_TM, 3 D_TOD_DT, 6 DT_DATE, 7 DT_DAY, 8 DT_TOD, 33 S5TI_TIM, 34 SB_DT_DT, 35 SB_DT_TM,
// 40 TIM_S5TI (S7-IEC-01 … -03).
#include <algorithm>
#include <array>
#include <functional>

#include "address/constant.h"
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::int64_t kDay = 86'400'000;
// DT#1990-01-01-00:00:00.000 to DT#2089-12-31-23:59:59.999
constexpr std::int64_t kLast = 36'525 * kDay - 1;

// An invalid DT counts as its lower limit, BIE 0.
std::int64_t dateAndTime(Arguments& a, std::size_t i) {
  const Region bytes = a.composite(i, 8, cpu::Access::Read);
  const auto value = bytes ? cpu::fromDateAndTime(bytes.data) : std::nullopt;
  if (!value) a.fail();
  return value.value_or(0);
}

void store(Arguments& a, std::size_t i, std::int64_t milliseconds) {
  const std::int64_t limited = std::clamp<std::int64_t>(milliseconds, 0, kLast);
  if (limited != milliseconds) a.fail();
  const Region bytes = a.composite(i, 8, cpu::Access::Write);
  if (!bytes) return;
  const auto value = cpu::toDateAndTime(limited);
  std::copy(value.begin(), value.end(), bytes.data);
}

// Bytes that are ordered as the instants are, whether they are a date or not: 1990 to 1999 come in
// front of 2000, and the weekday beside the last digit does not count.
std::array<std::uint8_t, 8> ordered(Arguments& a, std::size_t i) {
  constexpr std::uint8_t kFirstYear = 0x90, kCentury = 0x70;
  std::array<std::uint8_t, 8> result{};
  const Region bytes = a.composite(i, result.size(), cpu::Access::Read);
  if (!bytes) return result;
  std::copy_n(bytes.data, result.size(), result.begin());
  const bool before2000 = result[0] >= kFirstYear;
  result[0] = static_cast<std::uint8_t>(before2000 ? result[0] - kFirstYear : result[0] + kCentury);
  result[7] &= 0xF0;
  return result;
}

// They report no error: a value that is no date is compared as it lies there.
template <typename Relation>
void compare(Arguments& a) {
  a.set(2, Relation{}(ordered(a, 0), ordered(a, 1)));
}

}  // namespace

void addTimeToDate(Arguments& a) { store(a, 2, dateAndTime(a, 0) + a.longInteger(1)); }
void subtractTimeFromDate(Arguments& a) { store(a, 2, dateAndTime(a, 0) - a.longInteger(1)); }

void subtractDates(Arguments& a) {
  const std::int64_t exact = dateAndTime(a, 0) - dateAndTime(a, 1);
  const std::int64_t limited = std::clamp<std::int64_t>(exact, INT32_MIN, INT32_MAX);
  if (limited != exact) a.fail();
  a.set(2, static_cast<std::uint32_t>(limited));
}

void combineDate(Arguments& a) {
  const std::int64_t time = a.value(1);
  if (time >= kDay) a.fail();
  store(a, 2, a.value(0) * kDay + std::min(time, kDay - 1));
}

void dateOfDate(Arguments& a) { a.set(1, static_cast<std::uint32_t>(dateAndTime(a, 0) / kDay)); }
void timeOfDate(Arguments& a) { a.set(1, static_cast<std::uint32_t>(dateAndTime(a, 0) % kDay)); }
void dayOfDate(Arguments& a) {
  a.set(1,
        static_cast<std::uint32_t>(weekday(static_cast<std::uint16_t>(dateAndTime(a, 0) / kDay))));
}

void s5TimeToTime(Arguments& a) {
  const auto milliseconds = decodeS5Time(static_cast<std::uint16_t>(a.value(0)));
  if (!milliseconds) a.fail();
  a.set(1, milliseconds.value_or(0));
}

// Rounded down; beyond 9990 s the largest S5TIME, below 0 the smallest.
void timeToS5Time(Arguments& a) {
  constexpr std::uint32_t kLongest = 0x3999;
  const std::int32_t time = a.longInteger(0);
  const auto coded =
      time < 0 ? std::optional<std::uint16_t>{} : encodeS5Time(static_cast<std::uint64_t>(time));
  if (!coded) a.fail();
  a.set(1, coded ? *coded : time < 0 ? 0u : kLongest);
}

void dateEqual(Arguments& a) { compare<std::equal_to<>>(a); }
void dateGreaterEqual(Arguments& a) { compare<std::greater_equal<>>(a); }
void dateGreater(Arguments& a) { compare<std::greater<>>(a); }
void dateLessEqual(Arguments& a) { compare<std::less_equal<>>(a); }
void dateLess(Arguments& a) { compare<std::less<>>(a); }
void dateNotEqual(Arguments& a) { compare<std::not_equal_to<>>(a); }

}  // namespace merker::system
