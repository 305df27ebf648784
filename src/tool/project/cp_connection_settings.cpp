// [[connection]] of merker.toml with kind = "tcp", "iso-on-tcp" or "udp", and "e-mail": connections
// of a CP 343-1 for AG_SEND and AG_RECV (S7-SFB-10); [program] libraries.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "catalogue/ethernet.h"
#include "project/partner_address.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::string_view kStandardName = "Standard Library", kCpName = "SIMATIC_NET_CP";

// "10.02" as hexadecimal bytes, any other text as its characters.
std::vector<std::uint8_t> tsapOf(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view part = upTo(rest, '.');
    const auto byte = part.size() == 2 ? wholeNumber(part, 16, 0xFF) : std::nullopt;
    if (!byte) return {text.begin(), text.end()};
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
  return bytes;
}

void readCpTsap(const Table& table, std::string_view key, std::vector<std::uint8_t>& tsap) {
  const std::string what =
      fmt::format("1 to {} characters, or hexadecimal bytes like \"10.02\"; ISO on TCP needs it",
                  CpConnectionParameters::kLongestTsap);
  const auto text = table.text(key, what);
  if (text) tsap = tsapOf(*text);
  const bool good = !tsap.empty() && tsap.size() <= CpConnectionParameters::kLongestTsap;
  if (!good && (text || !table.has(key))) table.mustBe(key, what);
}

// Which ports a connection needs: that of the partner to call it, the own one to be called; UDP
// has neither caller nor called.
bool needsPort(const CpConnectionParameters& one) {
  return one.kind == ConnectionKind::Udp || one.active;
}
bool needsLocalPort(const CpConnectionParameters& one) {
  return one.kind == ConnectionKind::Udp || !one.active;
}

void readCpPartner(const Table& table, CpConnectionParameters& connection) {
  const bool udp = connection.kind == ConnectionKind::Udp;
  const std::string what = fmt::format(
      "an address and a port like \"{}://127.0.0.1:2000\"; without active no port is needed",
      udp ? "udp" : "tcp");
  const auto text = table.text("partner", what);
  const auto there = text ? partnerAddress(*text, udp ? "udp" : "tcp") : std::nullopt;
  if (!there || (needsPort(connection) && !there->port)) {
    if (text || !table.has("partner")) table.mustBe("partner", what);
    return;
  }
  connection.host = there->host;
  connection.port = there->port.value_or(0);
}

void readLocalPort(const Table& table, CpConnectionParameters& connection) {
  constexpr std::uint32_t kFirst = 1, kLast = 65'535;
  if (const auto port = table.number("local_port", kFirst, kLast))
    connection.localPort = static_cast<std::uint16_t>(*port);
  else if (needsLocalPort(connection) && !table.has("local_port"))
    table.mustBe("local_port", "the port of this station where the partner's data come in");
}

// Each has an ID of its own, and a port where it listens.
void checkCpUnique(const Table& table, const CpConnectionParameters& added,
                   const std::vector<CpConnectionParameters>& all) {
  for (const CpConnectionParameters& other : all) {
    if (added.id == other.id)
      return table.mustBe("id", "another one than those of the CP's connections above");
    const bool both = needsLocalPort(added) && needsLocalPort(other) &&
                      (added.kind == ConnectionKind::Udp) == (other.kind == ConnectionKind::Udp);
    if (both && added.localPort == other.localPort)
      return table.mustBe("local_port",
                          fmt::format("another one than that of the connection {}", other.id));
  }
}

void readPartnerConnection(const Table& table, CpConnectionParameters& connection) {
  const bool iso = connection.kind == ConnectionKind::IsoOnTcp;
  const bool udp = connection.kind == ConnectionKind::Udp;
  std::vector<std::string_view> keys = {"kind", "id", "partner", "local_port"};
  if (!udp) keys.push_back("active");
  if (iso) keys.insert(keys.end(), {"local_tsap", "partner_tsap"});
  table.allow(keys);
  if (!udp) connection.active = table.flag("active").value_or(true);
  readCpPartner(table, connection);
  readLocalPort(table, connection);
  if (!iso) return;
  readCpTsap(table, "local_tsap", connection.localTsap);
  readCpTsap(table, "partner_tsap", connection.partnerTsap);
}

bool hasCp(const Settings& settings) {
  return settings.hardware && std::ranges::any_of(settings.hardware->modules, [](const auto& one) {
           return hasEthernet(*one.type);
         });
}

// Whoever plugs a CP copies its blocks into the project.
Libraries usualLibraries(const Settings& settings) {
  if (hasCp(settings)) return {BlockLibrary::NetCp, BlockLibrary::Standard};
  if (hasEthernet(*settings.model)) return {BlockLibrary::Standard, BlockLibrary::NetCp};
  return standardLibraries();
}

}  // namespace

ConnectionKind readConnectionKind(const Table& table) {
  const auto which = table.choice("kind", {"s7", "tcp", "iso-on-tcp", "udp", "e-mail"});
  return static_cast<ConnectionKind>(which.value_or(0));
}

std::optional<std::uint8_t> readCpId(const Table& table, std::string_view key) {
  const auto id = table.number(key, 1, CpConnectionParameters::kHighestId);
  if (!id && !table.has(key))
    table.mustBe(key, fmt::format("1 to {}, as AG_SEND and AG_RECV name the connection",
                                  CpConnectionParameters::kHighestId));
  return id ? std::optional(static_cast<std::uint8_t>(*id)) : std::nullopt;
}

void readCpConnection(const Table& table, ConnectionKind kind,
                      CommunicationParameters& parameters) {
  CpConnectionParameters connection{.kind = kind};
  const auto id = readCpId(table, "id");
  kind == ConnectionKind::Mail ? readCpMail(table, connection)
                               : readPartnerConnection(table, connection);
  if (!id) return;
  connection.id = *id;
  checkCpUnique(table, connection, parameters.ofCp);
  parameters.ofCp.push_back(std::move(connection));
}

void requireCp(const Table& root, const Settings& settings) {
  const auto isMail = [](const auto& one) { return one.kind == ConnectionKind::Mail; };
  if (std::ranges::all_of(settings.communication.ofCp, isMail) || hasCp(settings)) return;
  for (const Table& table : root.tables("connection"))
    if (table.has("kind"))
      return table.mustBe("kind", "\"s7\", or the station needs a CP 343-1 ([[module]])");
}

Libraries readLibraries(const Table& root, const Settings& settings) {
  const auto program = root.table("program");
  if (!program || !program->has("libraries")) return usualLibraries(settings);
  const std::string what = fmt::format(
      "a list of \"{}\" and \"{}\"; of a number that both have the "
      "first one's block is called",
      kStandardName, kCpName);
  Libraries libraries;
  for (const Table::Text& one :
       program->texts("libraries", what).value_or(std::vector<Table::Text>{})) {
    const bool cp = equalsIgnoreCase(one.text, kCpName);
    if (!cp && !equalsIgnoreCase(one.text, kStandardName))
      program->mustBe("libraries", what);
    else
      libraries.push_back(cp ? BlockLibrary::NetCp : BlockLibrary::Standard);
  }
  return libraries;
}

}  // namespace merker::project
