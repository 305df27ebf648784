#include "base/visible.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace merker {
namespace {

// C0, DEL and C1.
bool isControl(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

}  // namespace

std::string visible(std::string_view utf8) {
  std::string result;
  for (std::size_t at = 0; at < utf8.size();) {
    const std::size_t begin = at;
    const char32_t c = nextCharacter(utf8, at);
    if (c == kReplacement && at - begin == 1)  // a byte that is no UTF-8
      result += fmt::format("\\x{:02X}", static_cast<unsigned char>(utf8[begin]));
    else if (isControl(c))
      result += fmt::format("\\x{:02X}", static_cast<unsigned>(c));
    else
      result += utf8.substr(begin, at - begin);
  }
  return result;
}

}  // namespace merker
