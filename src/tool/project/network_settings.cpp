// merker.toml of a project of several stations.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

// What makes a merker.toml one of several stations: it describes none itself.
constexpr std::string_view kNetworkKeys[] = {"project", "station",    "subnet", "global_data",
                                             "slave",   "connection", "plant"};

bool isKnown(const std::string& key) {
  return std::ranges::find(kNetworkKeys, key) != std::end(kNetworkKeys);
}

void allowKnown(const Table& root) {
  for (const std::string& key : root.keys())
    if (!isKnown(key))
      root.problems().add(ProblemCode::P0704, root.placeOf(key), key,
                          fmt::format("left out: a project of several stations has no [{}] of its "
                                      "own, its stations have",
                                      key));
}

void readStations(const Table& root, Network& network) {
  for (const Table& table : root.tables("station", kMostStations)) {
    auto station = readStation(table);
    if (!station) continue;
    if (findStation(network, station->name))
      table.problems().add(ProblemCode::P0742, table.at("name"), station->name,
                           "another station above");
    else
      network.stations.push_back(std::move(*station));
  }
}

}  // namespace

// A station names one other at most, that at its X27.
bool namesOnlyStations(const Table& root) {
  const toml::node* const stations = root.node("station");
  if (stations == nullptr) return false;
  const toml::array* const list = stations->as_array();
  return std::ranges::all_of(root.keys(), isKnown) || (list != nullptr && list->size() > 1);
}

Network readNetwork(const Table& root) {
  Network network;
  allowKnown(root);
  readStations(root, network);
  readSubnets(root, network);
  network.profibus = readDpSubnets(root, &network);
  network.plants = root.has("plant");
  readGlobalData(root, network);
  readStationConnections(root, network);
  return network;
}

std::optional<std::size_t> findStation(const Network& network, std::string_view name) {
  const auto found = std::ranges::find_if(
      network.stations, [&](const OtherStation& one) { return equalsIgnoreCase(one.name, name); });
  if (found == network.stations.end()) return std::nullopt;
  return static_cast<std::size_t>(found - network.stations.begin());
}

std::string stationNames(const Network& network) {
  constexpr std::size_t kShown = 10;
  std::string list;
  for (std::size_t i = 0; i < network.stations.size() && i < kShown; ++i)
    list += (i == 0 ? "" : ", ") + network.stations[i].name;
  return network.stations.size() > kShown ? list + ", …" : list;
}

}  // namespace merker::project
