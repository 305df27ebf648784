// [[connection]] of merker.toml: configured S7 connections (S7-NETPRO-08).
#include <fmt/format.h>

#include <algorithm>

#include "project/partner_address.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint32_t kLastRack = 7, kLastSlot = 31;

// Whoever is called needs no port of who calls.
bool readPartner(std::string_view text, ConnectionParameters& connection) {
  const auto there = partnerAddress(text, "tcp");
  if (!there || (connection.active && !there->port)) return false;
  connection.host = there->host;
  connection.port = there->port.value_or(connection.port);
  return true;
}

// "10.02": connection resource, and rack * 32 + slot.
void readTsap(const Table& table, std::string_view key, ConnectionParameters::Tsap& tsap) {
  constexpr std::string_view kWhat = "two hexadecimal bytes like \"10.02\"";
  const auto text = table.text(key, kWhat);
  if (!text) return;
  std::string_view rest = *text;
  const auto resource = wholeNumber(upTo(rest, '.'), 16, 0xFF);
  const auto place = wholeNumber(rest, 16, 0xFF);
  if (resource && place)
    tsap = {static_cast<std::uint8_t>(*resource), static_cast<std::uint8_t>(*place)};
  else
    table.mustBe(key, kWhat);
}

ConnectionParameters readS7Connection(const Table& table) {
  table.allow({"kind", "id", "partner", "active", "rack", "slot", "local_tsap", "partner_tsap"});
  ConnectionParameters connection;
  connection.id = readConnectionId(table, "id").value_or(connection.id);
  connection.active = table.flag("active").value_or(true);
  constexpr std::string_view kPartner =
      "an address and a port like \"tcp://192.168.0.2:102\"; without active no port is needed";
  const auto partner = table.text("partner", kPartner);
  const bool missing = !table.has("partner");
  if (missing || (partner && !readPartner(*partner, connection))) table.mustBe("partner", kPartner);
  const std::uint32_t rack = table.number("rack", 0, kLastRack).value_or(0);
  const std::uint32_t slot = table.number("slot", 0, kLastSlot).value_or(2);
  connection.partner[1] = static_cast<std::uint8_t>(rack * 32 + slot);
  readTsap(table, "local_tsap", connection.local);
  readTsap(table, "partner_tsap", connection.partner);
  return connection;
}

std::string idText(const ConnectionParameters& connection) {
  return fmt::format("connection W#16#{:X}", connection.id);
}

// Whoever is called tells its connections apart by the partner and the two TSAPs.
bool sameCall(const ConnectionParameters& one, const ConnectionParameters& other) {
  return !one.active && !other.active && one.host == other.host && one.local == other.local &&
         one.partner == other.partner;
}

void checkUnique(const Table& table, const ConnectionParameters& added,
                 const std::vector<ConnectionParameters>& all) {
  for (const ConnectionParameters& other : all) {
    if (added.id == other.id)
      return table.mustBe("id", "another one than those of the connections above");
    if (sameCall(added, other))
      return table.mustBe("local_tsap", "or partner_tsap another one than those of " +
                                            idText(other) + ", which has the same partner");
  }
}

}  // namespace

std::optional<std::uint16_t> readConnectionId(const Table& table, std::string_view key) {
  constexpr std::string_view kPrefix = "W#16#";
  const auto* const node = table.node(key);
  std::optional<std::uint32_t> id;
  if (node != nullptr && node->is_integer())
    id = static_cast<std::uint32_t>(std::clamp<std::int64_t>(node->as_integer()->get(), 0, 0xFFFF));
  if (node != nullptr && node->is_string()) {
    std::string_view text = node->as_string()->get();
    if (text.starts_with(kPrefix)) id = wholeNumber(text.substr(kPrefix.size()), 16, 0xFFFF);
  }
  if (id && *id >= 1 && *id <= ConnectionParameters::kHighestId)
    return static_cast<std::uint16_t>(*id);
  table.mustBe(key, "the local ID as blocks name it, from \"W#16#1\" to \"W#16#FFF\"");
  return std::nullopt;
}

void readConfigured(const Table& root, CommunicationParameters& parameters) {
  const std::uint32_t kept = parameters.pg + parameters.op + parameters.basic;
  for (const Table& table : root.tables("connection")) {
    const ConnectionKind kind = readConnectionKind(table);
    if (kind != ConnectionKind::S7) {
      readCpConnection(table, kind, parameters);
      continue;
    }
    ConnectionParameters connection = readS7Connection(table);
    checkUnique(table, connection, parameters.configured);
    parameters.configured.push_back(std::move(connection));
    const auto count = static_cast<std::uint32_t>(parameters.configured.size());
    if (parameters.connections && count + kept > *parameters.connections)
      return table.mustBe(
          "id", fmt::format("one of at most {} connections: this CPU has {}, of which {} are kept",
                            *parameters.connections - kept, *parameters.connections, kept));
  }
}

}  // namespace merker::project
