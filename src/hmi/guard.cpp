#include "hmi/guard.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

namespace merker::hmi {
namespace {

bool isHostCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == ':' || c == '[' || c == ']';
}

// "[::1]:8080" → "[::1]", "localhost:8080" → "localhost". The port does not matter: it may be
// another one outside of a container.
std::string_view nameOf(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

constexpr std::string_view kToken = "token=";

std::string_view tokenOf(std::string_view target) {
  const std::size_t query = target.find('?');
  std::string_view rest = query == std::string_view::npos ? "" : target.substr(query + 1);
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('&'));
    if (part.starts_with(kToken)) return part.substr(kToken.size());
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
  }
  return {};
}

}  // namespace

bool Guard::host(std::string_view host) const {
  if (host.empty() || host.size() > 255) return false;
  if (!std::all_of(host.begin(), host.end(), isHostCharacter)) return false;
  const std::string_view name = nameOf(host);
  return !local_ || name == "127.0.0.1" || name == "localhost" || name == "[::1]";
}

bool Guard::origin(std::string_view origin, std::string_view host) const {
  return origin.empty() || origin == (tls_ ? "https://" : "http://") + std::string(host);
}

bool Guard::token(std::string_view target) const {
  const std::string_view given = tokenOf(target);
  unsigned difference = given.size() == token_.size() ? 0 : 1;
  for (std::size_t i = 0; i < token_.size(); ++i)
    difference |= static_cast<unsigned char>(token_[i] ^ (i < given.size() ? given[i] : 0));
  return token_.empty() || difference == 0;
}

std::string numeric(std::string_view address) {
  return std::string(address == "localhost" ? "127.0.0.1" : address);
}

bool isLocalAddress(std::string_view address) {
  boost::system::error_code error;
  const auto parsed = boost::asio::ip::make_address(numeric(address), error);
  return !error && parsed.is_loopback();
}

}  // namespace merker::hmi
