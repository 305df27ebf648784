// Lengths of time and dates as text.
#include <fmt/format.h>

#include "address/notation.h"
#include "base/bcd.h"

namespace merker {
namespace notation {
namespace {

constexpr std::uint16_t kLastDate = 65378;                 // D#2168-12-31
constexpr std::uint32_t kMillisecondsPerDay = 86'400'000;  // TOD ends one before it

std::string lengthOfTime(std::uint64_t milliseconds) {
  struct Part {
    std::string_view name;
    std::uint64_t length;
  };
  constexpr Part kParts[] = {
      {"D", 86'400'000}, {"H", 3'600'000}, {"M", 60'000}, {"S", 1'000}, {"MS", 1}};
  if (milliseconds == 0) return "0MS";
  std::string text;
  for (const Part& part : kParts) {
    if (milliseconds >= part.length)
      text += fmt::format("{}{}", milliseconds / part.length, part.name);
    milliseconds %= part.length;
  }
  return text;
}

}  // namespace

std::string writeTime(std::uint32_t bits) {
  const bool negative = bits >> 31 != 0;
  const std::uint32_t magnitude = negative ? 0u - bits : bits;
  return fmt::format("T#{}{}", negative ? "-" : "", lengthOfTime(magnitude));
}

std::string writeS5Time(std::uint32_t bits) {
  const auto length = bits < 0x4000 ? decodeS5Time(static_cast<std::uint16_t>(bits)) : std::nullopt;
  return length ? "S5T#" + lengthOfTime(*length) : std::string();
}

std::string writeDate(std::uint32_t days) {
  if (days > kLastDate) return {};
  int year = 0, month = 0, day = 0;
  dateFromDays(static_cast<std::uint16_t>(days), year, month, day);
  return fmt::format("D#{:04}-{:02}-{:02}", year, month, day);
}

std::string writeTimeOfDay(std::uint32_t ms) {
  if (ms >= kMillisecondsPerDay) return {};
  return fmt::format("TOD#{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60,
                     ms / 1000 % 60, ms % 1000);
}

}  // namespace notation

std::string formatDateAndTime(std::uint64_t bcd) {
  const auto part = [bcd](int shift, int digits) {
    return fromBcd(static_cast<std::uint32_t>(bcd >> shift), digits).value_or(0);
  };
  const std::uint32_t year = part(56, 2);
  const std::string text =
      fmt::format("DT#{:04}-{:02}-{:02}-{:02}:{:02}:{:02}.{:03}", year + (year >= 90 ? 1900 : 2000),
                  part(48, 2), part(40, 2), part(32, 2), part(24, 2), part(16, 2), part(4, 3));
  // Not a date with its right weekday: show what is there.
  const auto again = parseDateAndTime(text, {});
  return again && (*again ^ bcd) >> 4 == 0 ? text : fmt::format("16#{:016X}", bcd);
}

}  // namespace merker
