#include "s7_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace merker::app {
namespace {

constexpr struct {
  std::string_view code, text;
} kReasons[] = {{"resource", "no connection was free for its kind"},
                {"slot", "it called another rack or slot"},
                {"socket", "too many sockets were open"},
                {"power", "the station has no power"},
                {"way", "no subnet leads to the station that it called"},
                {"transport", "broken off, no ISO on TCP"},
                {"protocol", "broken off, no S7 communication"},
                {"late", "broken off, something did not come in time"},
                {"unread", "broken off, it did not read its answers"},
                {"room", "broken off without a setup, to make room for another one"},
                {"protection", "a request needed the password"},
                {"password", "wrong password, or too many of them"},
                {"setup", "its setup was wrong or missing"}};

std::string_view reasonText(std::string_view code) {
  const auto* const found =
      std::ranges::find(kReasons, code, [](const auto& row) { return row.code; });
  return found == std::end(kReasons) ? code : found->text;
}

std::string partnerText(const workbench::S7PartnerRow& row) {
  return row.port == 0 ? row.host : fmt::format("{}:{}", row.host, row.port);
}

// A partner on another computer is called only if clients may come from there, too.
std::string_view stateText(std::string_view code) {
  return code == "outside" ? "not called" : code;
}

std::string headText(const workbench::S7Outside& outside) {
  const std::string all =
      outside.connections ? fmt::format(" of {}", *outside.connections) : std::string();
  return fmt::format(
      "S7 communication at {}: {}{} connections in use; kept: PG {}, OP {}, others {}\n"
      "{} requests, {} of them denied; connections: {} refused, {} broken off\n",
      outside.place, outside.clients.size() + outside.partners.size(), all, outside.pg, outside.op,
      outside.basic, outside.requests, outside.denied, outside.refused, outside.broken);
}

}  // namespace

std::string s7Text(const workbench::S7Outside& outside) {
  std::string text = headText(outside);
  if (!outside.warning.empty()) text += "warning: " + outside.warning + '\n';
  if (!outside.clients.empty())
    text += fmt::format("{:<24}{:<7}{:>5}{:>10}{:>10}{:>12}{:>12}\n", "partner", "kind", "PDU",
                        "seconds", "requests", "octets in", "octets out");
  for (const auto& row : outside.clients)
    text += fmt::format("{:<24}{:<7}{:>5}{:>10}{:>10}{:>12}{:>12}\n", row.partner, row.kind,
                        row.pdu, row.seconds, row.requests, row.received, row.sent);
  if (!outside.partners.empty())
    text += fmt::format("{:<12}{:<24}{:<9}{:<11}{:>5}\n", "connection", "partner", "active",
                        "state", "PDU");
  for (const auto& row : outside.partners)
    text += fmt::format("{:<12}{:<24}{:<9}{:<11}{:>5}\n", row.id, partnerText(row),
                        row.active ? "yes" : "no", stateText(row.state), row.pdu);
  for (const auto& row : outside.refusals)
    text +=
        fmt::format("refused {} s ago: {}: {}{}\n", row.seconds, row.partner, reasonText(row.why),
                    row.times > 1 ? fmt::format(" ({} times)", row.times) : std::string());
  return text;
}

}  // namespace merker::app
