// FC 5 DI_STRNG, 16 I_STRNG, 30 R_STRNG, 37 STRNG_DI, 38 STRNG_I, 39 STRNG_R (S7-IEC-07).
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>

#include "system/text.h"

namespace merker::system {
namespace {

// A sign of + is allowed, blanks in front too.
std::string_view digits(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  std::string_view rest =
      first == std::string::npos ? std::string_view() : std::string_view(text).substr(first);
  const bool plus = rest.size() > 1 && rest[0] == '+' && rest[1] != '-';
  return plus ? rest.substr(1) : rest;
}

template <typename Number>
void toNumber(Arguments& a, std::uint32_t mask) {
  const std::string text = getText(a, 0);
  const std::string_view rest = digits(text);
  Number value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc() || end != rest.data() + rest.size()) {
    a.fail();
    value = 0;
  }
  a.set(1, static_cast<std::uint32_t>(value) & mask);
}

}  // namespace

void intToText(Arguments& a) { setText(a, 1, fmt::format("{:+d}", a.integer(0))); }
void dintToText(Arguments& a) { setText(a, 1, fmt::format("{:+d}", a.longInteger(0))); }

// ±v.nnnnnnnE±xx, always 14 characters.
void realToText(Arguments& a) {
  const float value = std::bit_cast<float>(a.value(0));
  if (!std::isfinite(value)) {
    a.fail();
    return setText(a, 1, {});
  }
  setText(a, 1, fmt::format("{:+.7E}", static_cast<double>(value)));
}

void textToInt(Arguments& a) { toNumber<std::int16_t>(a, 0xFFFF); }
void textToDint(Arguments& a) { toNumber<std::int32_t>(a, 0xFFFFFFFF); }

void textToReal(Arguments& a) {
  const std::string text = getText(a, 0);
  const std::string_view rest = digits(text);
  float value = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  const bool good =
      error == std::errc() && end == rest.data() + rest.size() && std::isfinite(value);
  if (!good) a.fail();
  a.set(1, std::bit_cast<std::uint32_t>(good ? value : 0.0f));
}

}  // namespace merker::system
