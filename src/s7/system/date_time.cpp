// FC 1 AD_DT_TM, 3 D_TOD_DT, 6 DT_DATE, 7 DT_DAY, 8 DT_TOD, 33 S5TI_TIM, 34 SB_DT_DT, 35 SB_DT_TM,
// 40 TIM_S5TI (S7-IEC-01 … -03).
#include <algorithm>
#include <array>
#include <functional>

#include "address/constant.h"
#include "system/call.h"

namespace merker::system {
namespace {

constexpr std::int64_t kDay = 86'400'000;
// DT#1990-01-01-00:00:00.000 to DT#2089-12-31-23:59:59.999
constexpr std::int64_t kLast = 36'525 * kDay - 1;

// An invalid DT counts as its lower limit, BIE 0.
template <typename A>
std::int64_t dateAndTime(A& a, NameIn<A> name) {
  const Region bytes = a.composite(name, 8, cpu::Access::Read);
  const auto value = bytes ? cpu::fromDateAndTime(bytes.data) : std::nullopt;
  if (!value) a.fail();
  return value.value_or(0);
}

template <typename A>
void store(A& a, std::int64_t milliseconds) {
  const std::int64_t limited = std::clamp<std::int64_t>(milliseconds, 0, kLast);
  if (limited != milliseconds) a.fail();
  const Region bytes = a.composite("RET_VAL", 8, cpu::Access::Write);
  if (!bytes) return;
  const auto value = cpu::toDateAndTime(limited);
  std::copy(value.begin(), value.end(), bytes.data);
}

// Bytes that are ordered as the instants are, whether they are a date or not: 1990 to 1999 come in
// front of 2000, and the weekday beside the last digit does not count.
template <typename A>
std::array<std::uint8_t, 8> ordered(A& a, NameIn<A> name) {
  constexpr std::uint8_t kFirstYear = 0x90, kCentury = 0x70;
  std::array<std::uint8_t, 8> result{};
  const Region bytes = a.composite(name, result.size(), cpu::Access::Read);
  if (!bytes) return result;
  std::copy_n(bytes.data, result.size(), result.begin());
  const bool before2000 = result[0] >= kFirstYear;
  result[0] = static_cast<std::uint8_t>(before2000 ? result[0] - kFirstYear : result[0] + kCentury);
  result[7] &= 0xF0;
  return result;
}

// They report no error: a value that is no date is compared as it lies there.
template <typename Relation, typename A>
void compare(A& a) {
  a.set("RET_VAL", Relation{}(ordered(a, "DT1"), ordered(a, "DT2")));
}

}  // namespace

void addTimeToDate(Fc<1>& a) { store(a, dateAndTime(a, "T") + a.longInteger("D")); }
void subtractTimeFromDate(Fc<35>& a) { store(a, dateAndTime(a, "T") - a.longInteger("D")); }

void subtractDates(Fc<34>& a) {
  const std::int64_t exact = dateAndTime(a, "DT1") - dateAndTime(a, "DT2");
  const std::int64_t limited = std::clamp<std::int64_t>(exact, INT32_MIN, INT32_MAX);
  if (limited != exact) a.fail();
  a.set("RET_VAL", static_cast<std::uint32_t>(limited));
}

void combineDate(Fc<3>& a) {
  const std::int64_t time = a.value("IN2");
  if (time >= kDay) a.fail();
  store(a, a.value("IN1") * kDay + std::min(time, kDay - 1));
}

void dateOfDate(Fc<6>& a) {
  a.set("RET_VAL", static_cast<std::uint32_t>(dateAndTime(a, "IN") / kDay));
}
void timeOfDate(Fc<8>& a) {
  a.set("RET_VAL", static_cast<std::uint32_t>(dateAndTime(a, "IN") % kDay));
}
void dayOfDate(Fc<7>& a) {
  a.set("RET_VAL", static_cast<std::uint32_t>(
                       weekday(static_cast<std::uint16_t>(dateAndTime(a, "IN") / kDay))));
}

void s5TimeToTime(Fc<33>& a) {
  const auto milliseconds = decodeS5Time(static_cast<std::uint16_t>(a.value("IN")));
  if (!milliseconds) a.fail();
  a.set("RET_VAL", milliseconds.value_or(0));
}

// Rounded down; beyond 9990 s the largest S5TIME, below 0 the smallest.
void timeToS5Time(Fc<40>& a) {
  constexpr std::uint32_t kLongest = 0x3999;
  const std::int32_t time = a.longInteger("IN");
  const auto coded =
      time < 0 ? std::optional<std::uint16_t>{} : encodeS5Time(static_cast<std::uint64_t>(time));
  if (!coded) a.fail();
  a.set("RET_VAL", coded ? *coded : time < 0 ? 0u : kLongest);
}

void dateEqual(Fc<9>& a) { compare<std::equal_to<>>(a); }
void dateGreaterEqual(Fc<12>& a) { compare<std::greater_equal<>>(a); }
void dateGreater(Fc<14>& a) { compare<std::greater<>>(a); }
void dateLessEqual(Fc<18>& a) { compare<std::less_equal<>>(a); }
void dateLess(Fc<23>& a) { compare<std::less<>>(a); }
void dateNotEqual(Fc<28>& a) { compare<std::not_equal_to<>>(a); }

}  // namespace merker::system
