#include "server/guard.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

#include "base/text.h"

namespace merker::hmi {
namespace {

bool isHostCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == ':' || c == '[' || c == ']';
}

bool isPort(std::string_view text) {
  constexpr std::size_t kLongest = 5;
  return !text.empty() && text.size() <= kLongest &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// "[::1]:8080" → "[::1]", "localhost:8080" → "localhost". The port does not matter: it may be
// another one outside of a container. Empty: neither a name nor one with a port.
std::string_view nameOf(std::string_view host) {
  const std::size_t end =
      host.starts_with('[') ? host.find(']') + 1 : std::min(host.find(':'), host.size());
  const std::string_view rest = host.substr(end);
  const bool good = rest.empty() || (rest.front() == ':' && isPort(rest.substr(1)));
  return good ? host.substr(0, end) : std::string_view();
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

Guard::Guard(bool local, bool tls, std::string token, std::string_view address)
    : local_(local), tls_(tls), token_(std::move(token)), address_(numeric(address)) {
  if (address_.find(':') != std::string::npos) address_ = "[" + address_ + "]";
}

bool Guard::host(std::string_view host) const {
  if (host.empty() || host.size() > 255) return false;
  if (!std::all_of(host.begin(), host.end(), isHostCharacter)) return false;
  const std::string_view name = nameOf(host);
  if (name.empty()) return false;
  return !local_ || name == "127.0.0.1" || equalsIgnoreCase(name, "localhost") || name == "[::1]" ||
         name == address_;
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
