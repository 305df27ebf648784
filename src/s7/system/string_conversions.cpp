// FC 5 DI_STRNG, 16 I_STRNG, 30 R_STRNG, 37 STRNG_DI, 38 STRNG_I, 39 STRNG_R (S7-IEC-07).
#include <fmt/format.h>

#include <algorithm>
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

template <typename Number, typename A>
void toNumber(A& a, std::size_t longest, std::uint32_t mask) {
  const std::string text = getText(a, "S");
  const auto value =
      text.size() <= longest ? parsed<Number>(withoutPlus(text)) : std::optional<Number>{};
  if (!value) a.fail();
  a.set("RET_VAL", static_cast<std::uint32_t>(value.value_or(0)) & mask);
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

void intToText(Fc<16>& a) { setWholeText(a, "RET_VAL", fmt::format("{:+d}", a.integer("I"))); }
void dintToText(Fc<5>& a) { setWholeText(a, "RET_VAL", fmt::format("{:+d}", a.longInteger("I"))); }

void realToText(Fc<30>& a) {
  const float value = a.real("IN");
  if (!std::isfinite(value)) {
    a.fail();
    return setText(a, "RET_VAL", {});
  }
  setWholeText(a, "RET_VAL", textOf(value));
}

void textToInt(Fc<38>& a) { toNumber<std::int16_t>(a, kLongestInt, 0xFFFF); }
void textToDint(Fc<37>& a) { toNumber<std::int32_t>(a, kLongestDint, 0xFFFFFFFF); }

void textToReal(Fc<39>& a) {
  const std::string text = getText(a, "S");
  const auto value =
      hasFormOfReal(text) ? parsed<float>(withoutPlus(text)) : std::optional<float>{};
  const bool good = value && std::isfinite(*value);
  if (!good) a.fail();
  a.setReal("RET_VAL", good ? *value : 0.0f);
}

}  // namespace merker::system
