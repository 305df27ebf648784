#include "mc5/constant.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/bcd.h"
#include "mc5/s5_float.h"

namespace merker::mc5 {
namespace {

constexpr std::array kFormats{
    ConstantFormat{Format::Byte, "KB", 0x00, "0..255"},
    ConstantFormat{Format::Hex, "KH", 0x40, "0..FFFF, one to four hexadecimal digits"},
    ConstantFormat{Format::Counter, "KZ", 0x01, "0..999"},
    ConstantFormat{Format::Time, "KT", 0x02, "0.0..999.3, value and base 0 to 3"},
    ConstantFormat{Format::Fixed, "KF", 0x04, "-32768..+32767"},
    ConstantFormat{Format::Characters, "KC", 0x10,
                   "one or two ASCII characters, AB or 'AB'; quotes for blanks"},
    ConstantFormat{Format::Bytes, "KY", 0x20, "two numbers 0..255 with a comma: KY 1,2"},
    ConstantFormat{Format::Binary, "KM", 0x80, "16 binary digits"},
    ConstantFormat{Format::Float, "KG", 0x00,
                   "sign, up to 7 digits, sign, exponent: +1234567+02; up to +1701412+39"},
    ConstantFormat{Format::SignedByte, "BF", 0x00, "-127..+127"}};

// The largest number as the manual prints it, rounded to seven digits (9.3.3): it stands for the
// largest number there is.
constexpr double kPrintedLimit = 0.1701412e39;

// A whole number with an optional sign, all of the text.
std::optional<std::int64_t> integer(std::string_view text, int base = 10) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

std::optional<std::uint32_t> within(std::optional<std::int64_t> value, std::int64_t lowest,
                                    std::int64_t highest, std::uint32_t mask) {
  if (!value || *value < lowest || *value > highest) return std::nullopt;
  return static_cast<std::uint32_t>(*value) & mask;
}

std::optional<std::uint32_t> unsignedWithin(std::string_view text, std::int64_t highest,
                                            int base = 10) {
  if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  return within(integer(text, base), 0, highest, 0xFFFFFFFF);
}

std::optional<std::uint32_t> bcd(std::string_view text) {
  const auto value = unsignedWithin(text, 999);
  if (!value) return std::nullopt;
  return toBcd(*value, 3);
}

std::optional<std::uint32_t> time(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return std::nullopt;
  const auto value = bcd(text.substr(0, point));
  const auto base = unsignedWithin(text.substr(point + 1), 3);
  if (!value || !base || text.size() != point + 2) return std::nullopt;
  return *base << 12 | *value;
}

std::optional<std::uint32_t> bytePair(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  std::string_view second = text.substr(comma + 1);
  while (second.starts_with(' ')) second.remove_prefix(1);
  const auto high = unsignedWithin(text.substr(0, comma), 255);
  const auto low = unsignedWithin(second, 255);
  if (!high || !low) return std::nullopt;
  return *high << 8 | *low;
}

// Two characters, the first in the high byte; one is filled up with a blank.
std::optional<std::uint32_t> characters(std::string_view text) {
  const bool ascii =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 0x7F; });
  if (text.size() > 2 || !ascii) return std::nullopt;
  const auto at = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{' '};
  };
  return static_cast<std::uint32_t>(at(0) << 8 | at(1));
}

std::optional<std::uint32_t> binary(std::string_view text) {
  std::uint32_t value = 0;
  unsigned digits = 0;
  for (const char c : text) {
    if (c == ' ') continue;
    if ((c != '0' && c != '1') || ++digits > 16) return std::nullopt;
    value = value << 1 | (c == '1' ? 1u : 0u);
  }
  if (digits != 16) return std::nullopt;
  return value;
}

// +1234567+02 is 0.1234567 * 10^2 (S5-NUM-05).
std::optional<std::uint32_t> floating(std::string_view text) {
  const std::size_t second = text.find_last_of("+-");
  if (second == std::string_view::npos || second == 0) return std::nullopt;
  std::string_view fraction = text.substr(0, second);
  const auto mantissa = integer(fraction);
  const auto exponent = integer(text.substr(second));
  if (!mantissa || !exponent || std::abs(*exponent) > 39) return std::nullopt;
  if (fraction.front() == '+' || fraction.front() == '-') fraction.remove_prefix(1);
  if (fraction.empty() || fraction.size() > 7) return std::nullopt;
  const double value =
      static_cast<double>(*mantissa) *
      std::pow(10.0, static_cast<double>(*exponent) - static_cast<double>(fraction.size()));
  const FloatResult result = fromDouble(value);
  const bool limit = std::abs(value) <= kPrintedLimit;
  if (result.range != FloatRange::Fits && !(result.range == FloatRange::Overflow && limit))
    return std::nullopt;
  return result.bits;
}

}  // namespace

const ConstantFormat& info(Format format) { return kFormats[static_cast<std::size_t>(format)]; }

const ConstantFormat* findConstantFormat(std::string_view word) {
  for (const ConstantFormat& row : kFormats)
    if (row.word == word) return &row;
  return nullptr;
}

std::optional<std::uint32_t> constantBits(Format format, std::string_view text) {
  if (text.empty() && format != Format::Characters) return std::nullopt;
  switch (format) {
    case Format::Byte:
      return unsignedWithin(text, 255);
    case Format::Hex:
      if (text.size() > 4) return std::nullopt;
      return unsignedWithin(text, 0xFFFF, 16);
    case Format::Counter:
      return bcd(text);
    case Format::Time:
      return time(text);
    case Format::Fixed:
      return within(integer(text), -32768, 32767, 0xFFFF);
    case Format::Characters:
      return characters(text);
    case Format::Bytes:
      return bytePair(text);
    case Format::Binary:
      return binary(text);
    case Format::Float:
      return floating(text);
    case Format::SignedByte:
      return within(integer(text), -128, 127, 0xFF);
    case Format::Other:
      break;
  }
  return std::nullopt;
}

}  // namespace merker::mc5
