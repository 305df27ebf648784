#include "step7/version.h"

#include "step7/cursor.h"

namespace merker::step7 {

std::uint8_t parseVersion(std::string_view text) {
  unsigned high = 0, low = 0;
  std::size_t i = 0;
  while (i < text.size() && isDigit(text[i]))
    high = high * 10 + static_cast<unsigned>(text[i++] - '0');
  if (i < text.size() && text[i] == '.')
    for (++i; i < text.size() && isDigit(text[i]); ++i)
      low = low * 10 + static_cast<unsigned>(text[i] - '0');
  return static_cast<std::uint8_t>((high & 15) << 4 | (low & 15));
}

bool validVersion(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == text.size()) return false;
  const auto inRange = [](std::string_view digits) {
    unsigned value = 0;
    for (const char c : digits) {
      if (!isDigit(c)) return false;
      value = value * 10 + static_cast<unsigned>(c - '0');
      if (value > 15) return false;
    }
    return true;
  };
  return inRange(text.substr(0, dot)) && inRange(text.substr(dot + 1));
}

}  // namespace merker::step7
