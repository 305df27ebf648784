// FC 5 DI_STRNG, 16 I_STRNG, 30 R_STRNG, 37 STRNG_DI, 38 STRNG_I, 39 STRNG_R (S7-IEC-07).
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "system/text.h"

namespace merker::system {
namespace {

// The longest text of a number: sign and digits. Siemens' "System and Standard Functions", FC 37
// and FC 38; one that is longer is refused, whatever its value.
constexpr std::size_t kLongestInt = 6, kLongestDint = 11;
// FC 39 takes what FC 30 writes.
constexpr std::string_view kReal = "+0.0000000E+00";

bool isSign(char c) { return c == '+' || c == '-'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// `text` may begin with a sign of +, which from_chars does not know.
std::string_view withoutPlus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && isDigit(text[1]);
  return plus ? text.substr(1) : text;
}

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <typename Number>
void toNumber(Arguments& a, std::size_t longest, std::uint32_t mask) {
  const std::string text = getText(a, 0);
  const auto value =
      text.size() <= longest ? parsed<Number>(withoutPlus(text)) : std::optional<Number>{};
  if (!value) a.fail();
  a.set(1, static_cast<std::uint32_t>(value.value_or(0)) & mask);
}

// Sign where kReal has one, digit where it has one, and the same point and E.
bool hasFormOfReal(std::string_view text) {
  return std::equal(text.begin(), text.end(), kReal.begin(), kReal.end(), [](char c, char form) {
    return isSign(form) ? isSign(c) : isDigit(form) ? isDigit(c) : c == form;
  });
}

// ±0.nnnnnnnE±xx, always 14 characters: the first digit that is not 0 stands behind the point.
std::string textOf(float value) {
  if (value == 0) return std::signbit(value) ? "-0.0000000E+00" : "+0.0000000E+00";
  const std::string text = fmt::format("{:+.6E}", static_cast<double>(value));
  const std::size_t e = text.find('E');
  const int exponent = std::stoi(text.substr(e + 1)) + 1;
  return fmt::format("{}0.{}{}E{:+03d}", text[0], text[1], text.substr(3, e - 3), exponent);
}

}  // namespace

void intToText(Arguments& a) { setWholeText(a, 1, fmt::format("{:+d}", a.integer(0))); }
void dintToText(Arguments& a) { setWholeText(a, 1, fmt::format("{:+d}", a.longInteger(0))); }

void realToText(Arguments& a) {
  const float value = std::bit_cast<float>(a.value(0));
  if (!std::isfinite(value)) {
    a.fail();
    return setText(a, 1, {});
  }
  setWholeText(a, 1, textOf(value));
}

void textToInt(Arguments& a) { toNumber<std::int16_t>(a, kLongestInt, 0xFFFF); }
void textToDint(Arguments& a) { toNumber<std::int32_t>(a, kLongestDint, 0xFFFFFFFF); }

void textToReal(Arguments& a) {
  const std::string text = getText(a, 0);
  const auto value =
      hasFormOfReal(text) ? parsed<float>(withoutPlus(text)) : std::optional<float>{};
  const bool good = value && std::isfinite(*value);
  if (!good) a.fail();
  a.set(1, std::bit_cast<std::uint32_t>(good ? *value : 0.0f));
}

}  // namespace merker::system
