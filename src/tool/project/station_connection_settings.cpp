// [[connection]] of a project of several stations: S7 connections between two of them
// (S7-NETPRO-08), and those of their CPs.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::size_t kMostStationConnections = 10'000;
constexpr std::string_view kExample = "id = \"W#16#1\", local = \"Press\" and partner = \"Belt\"";

bool isOn(const Subnet& subnet, std::size_t station) {
  return std::ranges::count(subnet.nodes, station, &SubnetNode::station) > 0;
}

std::optional<std::size_t> readEnd(const Table& table, std::string_view key,
                                   const Network& network) {
  if (!table.has(key)) {
    table.problems().add(ProblemCode::P0744, table.place(), table.title(), kExample);
    return std::nullopt;
  }
  const auto name = table.text(key, "the name of a [[station]]");
  const auto station = name ? findStation(network, *name) : std::nullopt;
  if (name && !station) table.mustBe(key, "the name of a [[station]]: " + stationNames(network));
  return station;
}

// The subnet of both; without a name the first one. Nothing, and a problem: there is none.
std::optional<std::size_t> readCommonSubnet(const Table& table, const Network& network,
                                            const StationConnection& connection) {
  const auto name = table.text("subnet", "the name of a [[subnet]]");
  std::string common;
  for (std::size_t i = 0; i < network.subnets.size(); ++i) {
    const Subnet& one = network.subnets[i];
    if (!isOn(one, connection.local) || !isOn(one, connection.partner)) continue;
    if (connection.kind != ConnectionKind::S7 && one.kind != SubnetKind::Ethernet) continue;
    if (!name || equalsIgnoreCase(*name, one.name)) return i;
    common += (common.empty() ? "" : ", ") + one.name;
  }
  const std::string& local = network.stations[connection.local].name;
  const std::string& partner = network.stations[connection.partner].name;
  if (!common.empty())
    table.mustBe("subnet", fmt::format("a subnet of both stations: {}", common));
  else
    table.mustBe(
        "partner",
        connection.kind == ConnectionKind::S7
            ? fmt::format(
                  "on a subnet of {}; {} is on none of them, and no CPU routes a connection", local,
                  partner)
            : fmt::format("on an Ethernet of {}; {} is on none of them", local, partner));
  return std::nullopt;
}

// A local ID names one connection of its station, another one of its CP.
bool hasId(const Network& network, std::size_t station, ConnectionKind kind, std::uint16_t id) {
  return std::ranges::any_of(network.connections, [&](const StationConnection& one) {
    if ((one.kind == ConnectionKind::S7) != (kind == ConnectionKind::S7)) return false;
    return (one.local == station && one.id == id) ||
           (one.partner == station && one.partnerId == id);
  });
}

void checkId(const Table& table, std::string_view key, const Network& network, std::size_t station,
             ConnectionKind kind, std::uint16_t id) {
  if (hasId(network, station, kind, id))
    table.mustBe(key, fmt::format("another one: {} has a connection W#16#{:X} above",
                                  network.stations[station].name, id));
}

std::optional<std::uint16_t> readEndId(const Table& table, std::string_view key,
                                       ConnectionKind kind) {
  if (kind == ConnectionKind::S7) return readConnectionId(table, key);
  return readCpId(table, key);
}

}  // namespace

void readStationConnections(const Table& root, Network& network) {
  for (const Table& table : root.tables("connection", kMostStationConnections)) {
    table.allow({"kind", "id", "local", "partner", "partner_id", "subnet"});
    StationConnection connection;
    connection.position = table.place();
    connection.kind = readConnectionKind(table);
    if (connection.kind == ConnectionKind::Mail) {
      table.mustBe("kind",
                   "another one; e-mails are a [[connection]] of the station's merker.toml");
      continue;
    }
    const auto id = readEndId(table, "id", connection.kind);
    const auto local = readEnd(table, "local", network);
    const auto partner = readEnd(table, "partner", network);
    if (table.has("partner_id") || connection.kind != ConnectionKind::S7)
      connection.partnerId = readEndId(table, "partner_id", connection.kind);
    if (!id || !local || !partner) continue;
    if (connection.kind != ConnectionKind::S7 && !connection.partnerId) continue;
    if (local == partner) {
      table.mustBe("partner", "another station than local");
      continue;
    }
    connection.id = *id;
    connection.local = *local;
    connection.partner = *partner;
    connection.localAt = table.at("local");
    connection.partnerAt = table.at("partner");
    checkId(table, "id", network, *local, connection.kind, *id);
    if (connection.partnerId)
      checkId(table, "partner_id", network, *partner, connection.kind, *connection.partnerId);
    const auto subnet = readCommonSubnet(table, network, connection);
    if (!subnet) continue;
    connection.subnet = *subnet;
    network.connections.push_back(connection);
  }
}

}  // namespace merker::project
