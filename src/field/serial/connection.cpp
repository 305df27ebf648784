#include "serial/connection.h"

#include <charconv>
#include <utility>

namespace merker::serial {
namespace {

using Kind = Connection::Kind;

constexpr std::pair<std::string_view, Kind> kKinds[] = {
    {"pty:", Kind::Pty},         {"device:", Kind::Device}, {"listen:", Kind::Listen},
    {"connect:", Kind::Connect}, {"replay:", Kind::Replay}, {"station:", Kind::Station},
    {"rfc2217:", Kind::ComPort},
};

bool calls(Kind kind) { return kind == Kind::Connect || kind == Kind::ComPort; }
bool isNetwork(Kind kind) { return kind == Kind::Listen || calls(kind); }

// HOST:PORT, for a side that waits also PORT alone. An IPv6 address stands in brackets.
bool readPort(std::string_view text, Connection& connection) {
  const auto colon = text.rfind(':');
  std::string_view host =
      colon == std::string_view::npos ? std::string_view{} : text.substr(0, colon);
  const std::string_view port = colon == std::string_view::npos ? text : text.substr(colon + 1);
  unsigned number = 0;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (error != std::errc{} || end != port.data() + port.size() || number > 65'535) return false;
  if (host.size() > 1 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  if (calls(connection.kind) && (host.empty() || number == 0)) return false;
  connection.place = host;
  connection.port = static_cast<std::uint16_t>(number);
  return true;
}

}  // namespace

std::optional<Connection> parseConnection(std::string_view text) {
  if (text == "partner") return Connection{};
  for (const auto& [begin, kind] : kKinds) {
    if (!text.starts_with(begin)) continue;
    text.remove_prefix(begin.size());
    Connection connection{.kind = kind, .place = std::string(text)};
    if (text.empty() || (isNetwork(kind) && !readPort(text, connection))) return std::nullopt;
    return connection;
  }
  return std::nullopt;
}

std::string_view connectionForms() {
  return "valid forms: pty:PATH, device:PATH, listen:PORT, listen:HOST:PORT, connect:HOST:PORT, "
         "rfc2217:HOST:PORT, "
         "replay:FILE, station:NAME, partner";
}

}  // namespace merker::serial
