#include "server/options.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/guard.h"

namespace merker::hmi {
namespace {

constexpr std::size_t kShortestToken = 16;

// RFC 3986: unreserved characters.
bool isPlain(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
         c == '.' || c == '_' || c == '~';
}

bool isToken(std::string_view token) {
  return token.size() >= kShortestToken && std::ranges::all_of(token, isPlain);
}

}  // namespace

std::string wrongOptions(const Options& options) {
  const bool secure = !options.certificate.empty() && !options.key.empty();
  if (!isLocalAddress(options.address) && (!secure || options.token.empty()))
    return fmt::format(
        "{} is reachable from other computers: that needs --token, --certificate and --key",
        options.address);
  if (!options.token.empty() && !isToken(options.token))
    return fmt::format(
        "a token has {} characters or more: letters, digits, - . _ ~; "
        "`openssl rand -hex 16` makes a good one",
        kShortestToken);
  return {};
}

}  // namespace merker::hmi
