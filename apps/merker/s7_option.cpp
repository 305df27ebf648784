#include "s7_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <boost/asio/ip/address.hpp>
#include <charconv>
#include <iostream>

#include "server/guard.h"

namespace merker::app {
namespace {

std::optional<std::uint16_t> s7Port(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return port;
}

// "[::1]" → "::1"
std::string withoutBrackets(const std::string& address) {
  const bool brackets = address.size() > 2 && address.front() == '[' && address.back() == ']';
  return brackets ? address.substr(1, address.size() - 2) : address;
}

}  // namespace

void addS7(CLI::App& command, S7Option& option) {
  command.add_option("--s7", option.place,
                     "[ADDRESS:]PORT of an S7 server (RFC 1006; on 127.0.0.1 without an address; "
                     "PORT 0: any free one)");
}

std::optional<S7Place> s7Place(const S7Option& option, std::string& reason) {
  const std::size_t colon = option.place.rfind(':');
  const bool named = colon != std::string::npos;
  const auto port = s7Port(named ? option.place.substr(colon + 1) : option.place);
  S7Place place;
  if (named) place.address = hmi::numeric(withoutBrackets(option.place.substr(0, colon)));
  boost::system::error_code error;
  boost::asio::ip::make_address(place.address, error);
  if (!port || error) {
    reason = fmt::format("--s7: '{}' is not a valid place; write 102, 127.0.0.1:102 or [::1]:102",
                         option.place);
    return std::nullopt;
  }
  place.port = *port;
  return place;
}

std::optional<S7Place> firstS7Place(const std::string& command, const S7Option& option,
                                    std::size_t stations) {
  constexpr std::size_t kHighestPort = 65'535;
  std::string reason;
  const auto first = s7Place(option, reason);
  if (stations > kMostS7Stations)
    reason =
        fmt::format("--s7 serves at most {} stations; --station NAME serves one", kMostS7Stations);
  else if (first && first->port + stations - 1 > kHighestPort)
    reason =
        fmt::format("--s7: each of the {} stations has a port, the first one must be at most {}",
                    stations, kHighestPort + 1 - stations);
  if (reason.empty()) return first;
  std::cerr << command << ": " << reason << '\n';
  return std::nullopt;
}

S7Option s7OptionOf(const S7Place& first, std::size_t number) {
  const bool six = first.address.find(':') != std::string::npos;
  return {fmt::format("{}{}{}:{}", six ? "[" : "", first.address, six ? "]" : "",
                      first.port == 0 ? 0 : first.port + number)};
}

}  // namespace merker::app
