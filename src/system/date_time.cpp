// FC 1 AD_DT_TM, 3 D_TOD_DT, 6 DT_DATE, 7 DT_DAY, 8 DT_TOD, 33 S5TI_TIM, 34 SB_DT_DT, 35 SB_DT_TM,
// 40 TIM_S5TI (S7-IEC-01 … -03).
#include <algorithm>
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

void addTime(Arguments& a) { store(a, 2, dateAndTime(a, 0) + a.longInteger(1)); }
void subtractTime(Arguments& a) { store(a, 2, dateAndTime(a, 0) - a.longInteger(1)); }

void difference(Arguments& a) {
  const std::int64_t exact = dateAndTime(a, 0) - dateAndTime(a, 1);
  const std::int64_t limited = std::clamp<std::int64_t>(exact, INT32_MIN, INT32_MAX);
  if (limited != exact) a.fail();
  a.set(2, static_cast<std::uint32_t>(limited));
}

void combine(Arguments& a) {
  const std::int64_t time = a.value(1);
  if (time >= kDay) a.fail();
  store(a, 2, a.value(0) * kDay + std::min(time, kDay - 1));
}

void date(Arguments& a) { a.set(1, static_cast<std::uint32_t>(dateAndTime(a, 0) / kDay)); }
void timeOfDay(Arguments& a) { a.set(1, static_cast<std::uint32_t>(dateAndTime(a, 0) % kDay)); }
void day(Arguments& a) {
  a.set(1,
        static_cast<std::uint32_t>(weekday(static_cast<std::uint16_t>(dateAndTime(a, 0) / kDay))));
}

void fromS5Time(Arguments& a) {
  const auto milliseconds = decodeS5Time(static_cast<std::uint16_t>(a.value(0)));
  if (!milliseconds) a.fail();
  a.set(1, milliseconds.value_or(0));
}

// Rounded down; beyond 9990 s the largest S5TIME, below 0 the smallest.
void toS5Time(Arguments& a) {
  constexpr std::uint32_t kLongest = 0x3999;
  const std::int32_t time = a.longInteger(0);
  const auto coded =
      time < 0 ? std::optional<std::uint16_t>{} : encodeS5Time(static_cast<std::uint64_t>(time));
  if (!coded) a.fail();
  a.set(1, coded ? *coded : time < 0 ? 0u : kLongest);
}

}  // namespace

Functions dateTimeFunctions() {
  using enum TypeCode;
  return {
      {BlockKind::FC,
       1,
       "AD_DT_TM",
       {{"T", kIn, DateAndTime}, {"D", kIn, Time}, {"RET_VAL", kReturn, DateAndTime}},
       addTime},
      {BlockKind::FC,
       3,
       "D_TOD_DT",
       {{"IN1", kIn, Date}, {"IN2", kIn, TimeOfDay}, {"RET_VAL", kReturn, DateAndTime}},
       combine},
      {BlockKind::FC, 6, "DT_DATE", {{"IN", kIn, DateAndTime}, {"RET_VAL", kReturn, Date}}, date},
      {BlockKind::FC, 7, "DT_DAY", {{"IN", kIn, DateAndTime}, {"RET_VAL", kReturn, Int}}, day},
      {BlockKind::FC,
       8,
       "DT_TOD",
       {{"IN", kIn, DateAndTime}, {"RET_VAL", kReturn, TimeOfDay}},
       timeOfDay},
      {BlockKind::FC,
       33,
       "S5TI_TIM",
       {{"IN", kIn, S5Time}, {"RET_VAL", kReturn, Time}},
       fromS5Time},
      {BlockKind::FC,
       34,
       "SB_DT_DT",
       {{"T1", kIn, DateAndTime}, {"T2", kIn, DateAndTime}, {"RET_VAL", kReturn, Time}},
       difference},
      {BlockKind::FC,
       35,
       "SB_DT_TM",
       {{"T", kIn, DateAndTime}, {"D", kIn, Time}, {"RET_VAL", kReturn, DateAndTime}},
       subtractTime},
      {BlockKind::FC, 40, "TIM_S5TI", {{"IN", kIn, Time}, {"RET_VAL", kReturn, S5Time}}, toS5Time}};
}

namespace {

template <typename Relation>
void compare(Arguments& a) {
  a.set(2, Relation{}(dateAndTime(a, 0), dateAndTime(a, 1)));
}

}  // namespace

// S7-IEC-04
Functions dateTimeComparisons() {
  using enum TypeCode;
  const std::vector<Parameter> two{
      {"DT1", kIn, DateAndTime}, {"DT2", kIn, DateAndTime}, {"RET_VAL", kReturn, Bool}};
  using Number = std::int64_t;
  return {{BlockKind::FC, 9, "EQ_DT", two, compare<std::equal_to<Number>>},
          {BlockKind::FC, 12, "GE_DT", two, compare<std::greater_equal<Number>>},
          {BlockKind::FC, 14, "GT_DT", two, compare<std::greater<Number>>},
          {BlockKind::FC, 18, "LE_DT", two, compare<std::less_equal<Number>>},
          {BlockKind::FC, 23, "LT_DT", two, compare<std::less<Number>>},
          {BlockKind::FC, 28, "NE_DT", two, compare<std::not_equal_to<Number>>}};
}

}  // namespace merker::system
