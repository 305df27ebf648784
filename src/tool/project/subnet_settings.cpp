// [[subnet]]: MPI subnets of a project of several stations, and the rules that STEP 7 checks of
// them (S7-NET-02 to -06, S7-NETPRO-01).
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint32_t kHighestAddresses[] = {15, 31, 63, 126};
// MPI (S7-NET-25).
constexpr std::int64_t kRates[] = {19'200, 187'500};

void readHighest(const Table& table, MpiSubnet& subnet) {
  subnet.highest = table.number("highest", 0, kHighestMpiAddress).value_or(subnet.highest);
  if (std::ranges::find(kHighestAddresses, subnet.highest) == std::end(kHighestAddresses))
    table.mustBe("highest", "15, 31, 63 or 126");
}

// Nothing, and a problem, if the station is missing or on an MPI subnet already: a CPU has one
// interface.
std::optional<std::size_t> readNodeStation(const Table& table, const Network& network,
                                           const MpiSubnet& subnet) {
  const auto name = table.text("station", "the name of a [[station]]");
  if (!table.has("station"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "station = \"Press\" and address = 3");
  if (!name) return std::nullopt;
  const auto station = findStation(network, *name);
  const auto isOn = [&](const MpiSubnet& one) {
    return std::ranges::any_of(one.nodes,
                               [&](const SubnetNode& node) { return node.station == station; });
  };
  if (!station)
    table.mustBe("station", "the name of a [[station]]: " + stationNames(network));
  else if (isOn(subnet) || std::ranges::any_of(network.subnets, isOn))
    table.mustBe("station", "on one MPI subnet once; a CPU has one MPI interface");
  else
    return station;
  return std::nullopt;
}

void readNode(const Table& table, const Network& network, MpiSubnet& subnet) {
  table.allow({"station", "address", "grounded"});
  const auto station = readNodeStation(table, network, subnet);
  if (!table.has("address"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(), "address = 3");
  const auto address = table.number("address", kCpuMpiAddress, kHighestMpiAddress);
  if (!station || !address) return;
  const auto same = [&](const SubnetNode& node) { return node.address == *address; };
  if (std::ranges::any_of(subnet.nodes, same))
    return table.mustBe("address",
                        fmt::format("unique on the subnet; {} has another station", *address));
  if (*address > subnet.highest)
    return table.mustBe(
        "address", fmt::format("at most the highest address of the subnet, {}", subnet.highest));
  subnet.nodes.push_back(
      {*station, *address, table.at("station"), table.flag("grounded").value_or(true)});
}

}  // namespace

void readSubnets(const Table& root, Network& network) {
  for (const Table& table : root.tables("subnet")) {
    if (isDpSubnet(table)) continue;
    table.allow({"name", "kind", "baud", "highest", "nodes", "repeaters", "segments"});
    MpiSubnet subnet{table.text("name", "a text").value_or("MPI"), kRates[1], 31, {}};
    if (!table.has("kind"))
      table.problems().add(ProblemCode::P0744, table.place(), table.title(), "kind = \"mpi\"");
    (void)table.choice("kind", {"mpi", "profibus"});
    if (const auto rate = table.choice("baud", {"19.2k", "187.5k"})) subnet.rate = kRates[*rate];
    readHighest(table, subnet);
    for (const Table& node : table.tables("nodes", kMostStations)) readNode(node, network, subnet);
    readSegments(table, network, subnet);
    network.subnets.push_back(std::move(subnet));
  }
}

}  // namespace merker::project
