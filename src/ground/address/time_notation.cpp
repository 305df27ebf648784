// S5T#, T#, D#, TOD# and DT#: lengths of time, dates and times of day.
#include <algorithm>
#include <span>

#include "address/notation.h"
#include "base/bcd.h"

namespace merker::notation {
namespace {

struct Unit {
  std::string_view name;
  std::uint64_t milliseconds;
};
// In both mnemonics (S7-OPEN-27); an S5TIME has no days.
constexpr Unit kUnits[] = {
    {"D", 86'400'000}, {"H", 3'600'000}, {"M", 60'000}, {"S", 1'000}, {"MS", 1}};

struct Length {
  std::string_view type, example, units;
  std::span<const Unit> table;
};
constexpr Length kTime{"TIME", "T#14D20H45M23S123MS", "D, H, M, S, MS", kUnits};
constexpr Length kS5Time{"S5TIME", "S5T#1H10M20S", "H, M, S, MS", std::span(kUnits).subspan(1)};

// "1H10M20S" in milliseconds: each unit at most once, the largest first.
Result<std::uint64_t> readLength(Scanner& text, const Input& input, const Length& form) {
  std::uint64_t total = 0;
  std::size_t next = 0;
  do {
    const auto number = text.number();
    const std::string_view unit = text.letters();
    if (!number || unit.empty()) return misspelt(input, form.example);
    std::size_t i = 0;
    while (i < form.table.size() && form.table[i].name != unit) ++i;
    if (i == form.table.size())
      return makeProblem(ProblemCode::P0206, input.at, input.written, unit, form.type, form.units);
    if (i < next) return makeProblem(ProblemCode::P0207, input.at, input.written, form.units);
    next = i + 1;
    total += *number * form.table[i].milliseconds;
  } while (!text.atEnd());
  return total;
}

struct Day {
  int year = 0, month = 0, day = 0;
};

// Years of two digits: 90..99 are 19xx, 00..89 are 20xx (S7-TYPES-18).
std::optional<int> readYear(Scanner& text) {
  const auto year = text.number();
  if (!year || (text.digits() != 2 && text.digits() != 4)) return std::nullopt;
  const int value = static_cast<int>(*year);
  if (text.digits() == 4) return value;
  return value + (value >= 90 ? 1900 : 2000);
}

std::optional<Day> readDay(Scanner& text) {
  const auto year = readYear(text);
  if (!year || !text.take("-")) return std::nullopt;
  const auto month = text.number();
  if (!month || !text.take("-")) return std::nullopt;
  const auto day = text.number();
  if (!day) return std::nullopt;
  return Day{*year, static_cast<int>(std::min<std::uint64_t>(*month, 99)),
             static_cast<int>(std::min<std::uint64_t>(*day, 99))};
}

// Fraction of a second, one to three digits: .3 is 300 ms.
std::optional<std::uint64_t> readMilliseconds(Scanner& text) {
  auto value = text.number();
  if (!value || text.digits() > 3) return std::nullopt;
  for (std::size_t i = text.digits(); i < 3; ++i) *value *= 10;
  return value;
}

// "17:53:17.333" up to the end, in milliseconds since midnight.
Result<std::uint32_t> readClock(Scanner& text, const Input& input, std::string_view example) {
  std::uint64_t part[3] = {};
  for (int i = 0; i < 3; ++i) {
    const auto number = i == 0 || text.take(":") ? text.number() : std::nullopt;
    if (!number) return misspelt(input, example);
    part[i] = *number;
  }
  std::optional<std::uint64_t> fraction = 0;
  if (text.rest().starts_with(":")) return makeProblem(ProblemCode::P0203, input.at, input.written);
  if (text.take(".")) fraction = readMilliseconds(text);
  if (!fraction || !text.atEnd()) return misspelt(input, example);
  if (part[0] > 23 || part[1] > 59 || part[2] > 59)
    return outside(input, "0:0:0.0..23:59:59.999, the times of a day");
  return static_cast<std::uint32_t>(((part[0] * 60 + part[1]) * 60 + part[2]) * 1000 + *fraction);
}

Problem noSuchDay(const Input& input, const Day& day, std::string_view range) {
  if (day.year < 1990 || day.year > 2168) return outside(input, range);
  return makeProblem(ProblemCode::P0208, input.at, input.written, "day");
}

}  // namespace

Result<Constant> readS5Time(const Input& input) {
  constexpr std::string_view kRange = "S5T#10MS..S5T#2H46M30S";
  if (input.body.starts_with("-")) return outside(input, kRange);
  Scanner text(input.body);
  const auto length = readLength(text, input, kS5Time);
  if (!length) return length.error();
  const auto word = encodeS5Time(*length);
  // Lengths below the smallest base would all be nothing; a written 0 is meant.
  if (!word || (*word == 0 && *length > 0)) return outside(input, kRange);
  return Constant{ConstantFormat::S5Time, *word};
}

Result<Constant> readTime(const Input& input) {
  Scanner text(input.body);
  const bool negative = text.take("-");
  const auto length = readLength(text, input, kTime);
  if (!length) return length.error();
  if (*length > (negative ? 0x80000000u : 0x7FFFFFFFu))
    return outside(input, "T#-24D20H31M23S648MS..T#24D20H31M23S647MS");
  const auto milliseconds = static_cast<std::uint32_t>(*length);
  return Constant{ConstantFormat::Time, negative ? 0u - milliseconds : milliseconds};
}

Result<Constant> readDate(const Input& input) {
  Scanner text(input.body);
  const auto day = readDay(text);
  if (!day || !text.atEnd()) return misspelt(input, "D#1998-04-14");
  const auto days = daysSince1990(day->year, day->month, day->day);
  if (!days) return noSuchDay(input, *day, "D#1990-01-01..D#2168-12-31");
  return Constant{ConstantFormat::Date, *days};
}

Result<Constant> readTimeOfDay(const Input& input) {
  Scanner text(input.body);
  const auto clock = readClock(text, input, "TOD#17:53:17.333");
  if (!clock) return clock.error();
  return Constant{ConstantFormat::TimeOfDay, *clock};
}

Result<std::uint64_t> readDateAndTime(const Input& input) {
  constexpr std::string_view kExample = "DT#1998-04-14-17:53:17.333";
  constexpr std::string_view kRange = "DT#1990-01-01-0:0:0.0..DT#2089-12-31-23:59:59.999";
  Scanner text(input.body);
  const auto day = readDay(text);
  if (!day || !text.take("-")) return misspelt(input, kExample);
  const auto clock = readClock(text, input, kExample);
  if (!clock) return clock.error();
  const auto days = daysSince1990(day->year, day->month, day->day);
  if (!days) return noSuchDay(input, *day, kRange);
  if (day->year > 2089) return outside(input, kRange);
  const std::uint32_t seconds = *clock / 1000;
  const auto date = static_cast<unsigned>(day->year % 100 * 10000 + day->month * 100 + day->day);
  const std::uint32_t time = seconds / 3600 * 10000 + seconds / 60 % 60 * 100 + seconds % 60;
  return std::uint64_t{toBcd(date, 6)} << 40 | std::uint64_t{toBcd(time, 6)} << 16 |
         std::uint64_t{toBcd(*clock % 1000, 3)} << 4 | static_cast<unsigned>(weekday(*days));
}

}  // namespace merker::notation
