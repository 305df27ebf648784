#include "scenario/duration.h"

#include <fmt/format.h>

#include <array>

#include "address/constant.h"
#include "base/text.h"

namespace merker::simulator {
namespace {

constexpr std::int64_t kLongest = 100LL * 365 * 24 * 3600 * 1'000'000'000;

struct Unit {
  std::string_view name;
  std::int64_t ns;
};
// "ms" before "m" and "s": the first that fits is taken.
constexpr std::array kUnits = {
    Unit{"MS", 1'000'000},    Unit{"US", 1'000},         Unit{"NS", 1},
    Unit{"S", 1'000'000'000}, Unit{"M", 60'000'000'000}, Unit{"H", 3'600'000'000'000}};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// A decimal number times a unit, exact as long as it is a whole number of nanoseconds.
struct Number {
  std::int64_t whole = 0;
  std::int64_t fraction = 0;  // of `scale`
  std::int64_t scale = 1;
};

std::optional<Number> takeNumber(std::string_view& text) {
  Number number;
  std::size_t i = 0;
  for (; i < text.size() && isDigit(text[i]); ++i) {
    if (number.whole > kLongest / 10) return std::nullopt;
    number.whole = number.whole * 10 + (text[i] - '0');
  }
  if (i == 0) return std::nullopt;
  if (i + 1 < text.size() && text[i] == '.' && isDigit(text[i + 1])) {
    for (++i; i < text.size() && isDigit(text[i]); ++i) {
      if (number.scale >= 1'000'000'000) continue;  // below a nanosecond
      number.fraction = number.fraction * 10 + (text[i] - '0');
      number.scale *= 10;
    }
  }
  text.remove_prefix(i);
  return number;
}

std::optional<std::int64_t> takeUnit(std::string_view& text) {
  for (const Unit& unit : kUnits) {
    if (!text.starts_with(unit.name)) continue;
    text.remove_prefix(unit.name.size());
    return unit.ns;
  }
  return std::nullopt;
}

std::optional<Duration> parseUnits(std::string_view text) {
  std::int64_t sum = 0;
  while (!text.empty()) {
    const auto number = takeNumber(text);
    const auto unit = number ? takeUnit(text) : std::nullopt;
    if (!unit || number->whole > kLongest / *unit) return std::nullopt;
    // fraction < scale <= 1e9 and unit <= 3.6e12: the product needs the division first where both
    // are large
    const std::int64_t part = *unit % number->scale == 0
                                  ? number->fraction * (*unit / number->scale)
                                  : number->fraction * *unit / number->scale;
    sum += number->whole * *unit + part;
    if (sum > kLongest) return std::nullopt;
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  }
  return Duration{sum};
}

std::optional<Duration> parseTimeConstant(std::string_view text) {
  const auto constant = parseConstant(text, {});
  if (!constant) return std::nullopt;
  const std::uint32_t bits = constant.value().bits;
  if (constant.value().format == ConstantFormat::S5Time) {
    const auto ms = decodeS5Time(static_cast<std::uint16_t>(bits));
    return ms ? std::optional(Duration::milliseconds(*ms)) : std::nullopt;
  }
  const auto ms = static_cast<std::int32_t>(bits);
  if (constant.value().format != ConstantFormat::Time || ms < 0) return std::nullopt;
  return Duration::milliseconds(ms);
}

}  // namespace

std::optional<Duration> parseDuration(std::string_view text) {
  text = trim(text);
  if (text.empty()) return std::nullopt;
  if (text.find('#') != std::string_view::npos) return parseTimeConstant(text);
  const std::string letters = upper(text);
  return parseUnits(letters);
}

std::string formatSeconds(std::int64_t nanoseconds, int decimals) {
  std::string fraction = fmt::format("{:09}", nanoseconds % 1'000'000'000);
  fraction.resize(static_cast<std::size_t>(decimals));
  return fmt::format("{}.{}", nanoseconds / 1'000'000'000, fraction);
}

std::string formatTime(Instant time) {
  std::string text = formatSeconds(time.ns, 9);
  while (text.back() == '0' && text[text.size() - 4] != '.') text.pop_back();
  return text + " s";
}

}  // namespace merker::simulator
