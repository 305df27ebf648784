#include "base/mail_address.h"

#include <algorithm>

namespace merker {
namespace {

constexpr std::size_t kLongestAddress = 254;  // RFC 5321, 4.5.3.1.3
constexpr std::string_view kSpecial = "<>()[],;:\\\"";

constexpr bool isPlain(char c) {
  return c > ' ' && c < '\x7F' && kSpecial.find(c) == std::string_view::npos;
}

}  // namespace

bool isMailAddress(std::string_view text) {
  const std::size_t at = text.find('@');
  return text.size() <= kLongestAddress && at != std::string_view::npos && at > 0 &&
         at + 1 < text.size() && at == text.rfind('@') && std::ranges::all_of(text, isPlain);
}

}  // namespace merker
