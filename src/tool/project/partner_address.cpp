#include "project/partner_address.h"

#include <charconv>

namespace merker::project {
namespace {

std::optional<std::string> hostOf(std::string_view text) {
  if (text == "localhost") return "127.0.0.1";
  if (text == "::1") return std::string(text);
  std::string_view rest = text;
  for (int part = 0; part < 4; ++part)
    if (!wholeNumber(upTo(rest, '.'), 10, 255)) return std::nullopt;
  if (!rest.empty() || text.back() == '.') return std::nullopt;
  return std::string(text);
}

}  // namespace

std::optional<std::uint32_t> wholeNumber(std::string_view text, int base, std::uint32_t most) {
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value, base);
  if (text.empty() || error != std::errc() || end != last || value > most) return std::nullopt;
  return value;
}

std::string_view upTo(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return part;
}

std::optional<PartnerAddress> partnerAddress(std::string_view text, std::string_view scheme) {
  constexpr std::string_view kSlashes = "://";
  if (!text.starts_with(scheme)) return std::nullopt;
  text.remove_prefix(scheme.size());
  if (!text.starts_with(kSlashes)) return std::nullopt;
  text.remove_prefix(kSlashes.size());
  const bool six = text.starts_with('[');
  if (six) text.remove_prefix(1);
  const auto host = hostOf(upTo(text, six ? ']' : ':'));
  if (six && text.starts_with(':')) text.remove_prefix(1);
  const auto port = wholeNumber(text, 10, 0xFFFF);
  if (!host || (!port && !text.empty()) || port == 0u) return std::nullopt;
  PartnerAddress address{*host};
  if (port) address.port = static_cast<std::uint16_t>(*port);
  return address;
}

}  // namespace merker::project
