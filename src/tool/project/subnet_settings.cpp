// [[subnet]]: MPI and Ethernet subnets of a project of several stations, and the rules that STEP 7
// checks of them (S7-NET-02 to -06, S7-NETPRO-01).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

constexpr std::uint32_t kHighestAddresses[] = {15, 31, 63, 126};
// MPI (S7-NET-25).
constexpr std::int64_t kRates[] = {19'200, 187'500};

void readHighest(const Table& table, Subnet& subnet) {
  subnet.highest = table.number("highest", 0, kHighestMpiAddress).value_or(subnet.highest);
  if (std::ranges::find(kHighestAddresses, subnet.highest) == std::end(kHighestAddresses))
    table.mustBe("highest", "15, 31, 63 or 126");
}

// Nothing, and a problem, if the station is missing or on a subnet of this kind already: it has one
// such interface.
std::optional<std::size_t> readNodeStation(const Table& table, const Network& network,
                                           const Subnet& subnet) {
  const auto name = table.text("station", "the name of a [[station]]");
  if (!table.has("station"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "station = \"Press\" and address = 3");
  if (!name) return std::nullopt;
  const auto station = findStation(network, *name);
  const auto isOn = [&](const Subnet& one) {
    return one.kind == subnet.kind && std::ranges::any_of(one.nodes, [&](const SubnetNode& node) {
             return node.station == station;
           });
  };
  if (!station)
    table.mustBe("station", "the name of a [[station]]: " + stationNames(network));
  else if (isOn(subnet) || std::ranges::any_of(network.subnets, isOn))
    table.mustBe("station", subnet.kind == SubnetKind::Mpi
                                ? "on one MPI subnet once; a CPU has one MPI interface"
                                : "on one Ethernet subnet once");
  else
    return station;
  return std::nullopt;
}

void readMpiNode(const Table& table, const Network& network, Subnet& subnet) {
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

// "192.168.0.1": all of a subnet have the first three numbers in common (mask 255.255.255.0).
std::optional<std::uint32_t> lastNumber(std::string_view ip, std::string_view& front) {
  unsigned part[4] = {};
  const char* at = ip.data();
  const char* const end = at + ip.size();
  for (int i = 0; i < 4; ++i) {
    const auto read = std::from_chars(at, end, part[i]);
    const bool good = read.ec == std::errc() && part[i] <= 255 &&
                      (i == 3 ? read.ptr == end : read.ptr != end && *read.ptr == '.');
    if (!good) return std::nullopt;
    if (i < 3) at = read.ptr + 1;
  }
  front = ip.substr(0, static_cast<std::size_t>(at - ip.data()));
  return part[3] == 0 || part[3] == 255 ? std::nullopt : std::optional(part[3]);
}

void readEthernetNode(const Table& table, const Network& network, Subnet& subnet) {
  constexpr std::string_view kWhat = "an IP address like \"192.168.0.1\"";
  table.allow({"station", "address"});
  const auto station = readNodeStation(table, network, subnet);
  const auto ip = table.text("address", kWhat);
  if (!table.has("address"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "address = \"192.168.0.1\"");
  if (!station || !ip) return;
  std::string_view front, first;
  const auto last = lastNumber(*ip, front);
  if (!last) return table.mustBe("address", kWhat);
  if (!subnet.nodes.empty()) (void)lastNumber(subnet.nodes.front().ip, first);
  if (!subnet.nodes.empty() && front != first)
    return table.mustBe("address",
                        fmt::format("of the subnet of the others: {}1 to {}254", first, first));
  if (std::ranges::count(subnet.nodes, *last, &SubnetNode::address) > 0)
    return table.mustBe("address",
                        fmt::format("unique on the subnet; {} has another station", *ip));
  subnet.nodes.push_back({*station, *last, table.at("station"), true, *ip});
}

void readMpi(const Table& table, const Network& network, Subnet& subnet) {
  table.allow({"name", "kind", "baud", "highest", "nodes", "repeaters", "segments"});
  if (const auto rate = table.choice("baud", {"19.2k", "187.5k"})) subnet.rate = kRates[*rate];
  readHighest(table, subnet);
  for (const Table& node : table.tables("nodes", kMostStations)) readMpiNode(node, network, subnet);
  readSegments(table, network, subnet);
}

void readEthernet(const Table& table, const Network& network, Subnet& subnet) {
  constexpr std::int64_t kEthernetRates[] = {10'000'000, 100'000'000};
  table.allow({"name", "kind", "baud", "nodes"});
  subnet.kind = SubnetKind::Ethernet;
  subnet.highest = 254;
  subnet.rate = kEthernetRates[table.choice("baud", {"10M", "100M"}).value_or(1)];
  for (const Table& node : table.tables("nodes", kMostStations))
    readEthernetNode(node, network, subnet);
}

}  // namespace

// Scenarios and drawings name them.
void checkSubnetNames(const Table& root) {
  std::set<std::string> names;
  for (const Table& table : root.tables("subnet")) {
    const toml::node* const kind = table.node("kind");
    const std::string standard =
        isDpSubnet(table)                                                     ? "PROFIBUS"
        : kind != nullptr && equalsIgnoreCase(kind->value_or(""), "ethernet") ? "Ethernet"
                                                                              : "MPI";
    const toml::node* const given = table.node("name");
    const std::string name = given != nullptr ? given->value_or(standard) : standard;
    if (!names.insert(upper(name)).second)
      table.problems().add(ProblemCode::P0742, table.at("name"), name, "another subnet above");
  }
}

void readSubnets(const Table& root, Network& network) {
  for (const Table& table : root.tables("subnet")) {
    if (isDpSubnet(table)) continue;
    if (!table.has("kind"))
      table.problems().add(ProblemCode::P0744, table.place(), table.title(), "kind = \"mpi\"");
    const auto kind = table.choice("kind", {"mpi", "ethernet", "profibus"});
    if (!kind) continue;  // what else it has is that of an unknown kind
    const bool ethernet = kind == std::size_t{1};
    Subnet subnet;
    subnet.name = table.text("name", "a text").value_or(ethernet ? "Ethernet" : "MPI");
    ethernet ? readEthernet(table, network, subnet) : readMpi(table, network, subnet);
    network.subnets.push_back(std::move(subnet));
  }
}

}  // namespace merker::project
