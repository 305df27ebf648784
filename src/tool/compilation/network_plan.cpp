#include "compilation/network_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/slave.h"

namespace merker::compilation {
namespace {

// Null: its folder could not be read.
const Build* buildOf(const NetworkBuild& build, std::string_view name) {
  const auto found = std::ranges::find(build.stations, name, &NamedBuild::name);
  return found == build.stations.end() ? nullptr : found->build.get();
}

std::string modelOf(const Build& build) {
  if (build.isListing()) return build.controller()->modelName();
  return std::string(build.project.model->name);
}

std::string rateText(std::int64_t rate) {
  constexpr std::int64_t kMega = 1'000'000;
  return rate >= kMega ? fmt::format("{} Mbit/s", static_cast<double>(rate) / kMega)
                       : fmt::format("{} kbit/s", static_cast<double>(rate) / 1000);
}

// What the master calls its slave.
std::string nameOf(const io::DpMaster& master, std::uint32_t address) {
  const auto slave = std::ranges::find(master.slaves, address, &io::Slave::address);
  return slave == master.slaves.end() ? std::string() : slave->name;
}

PlannedSubnet planned(const io::DpMaster& master, std::size_t station) {
  PlannedSubnet result{.name = master.subnet,
                       .kind = "profibus",
                       .rate = rateText(master.rate),
                       .highest = master.highest,
                       .nodes = {{station, master.address}},
                       .segments = {}};
  for (const io::Slave& slave : master.slaves)
    if (!slave.intelligent) result.slaves.push_back({slave.address, slave.name, slave.model});
  std::ranges::sort(result.slaves, {}, &PlannedSlave::address);
  return result;
}

PlannedSubnet planned(const project::Subnet& subnet) {
  const bool ethernet = subnet.kind == project::SubnetKind::Ethernet;
  PlannedSubnet result{
      subnet.name,    ethernet ? "ethernet" : "mpi", rateText(subnet.rate), subnet.highest, {},
      subnet.segments};
  for (const project::SubnetNode& node : subnet.nodes)
    result.nodes.push_back({node.station, node.address, node.ip});
  std::ranges::sort(result.nodes, {}, &PlannedNode::address);
  return result;
}

void addConnections(const Build& build, std::size_t station, NetworkPlan& plan) {
  for (const ConnectionParameters& one : build.project.communication.configured)
    plan.connections.push_back({station, one.id, one.active,
                                one.active ? fmt::format("{}:{}", one.host, one.port) : one.host});
  for (const CpConnectionParameters& one : build.project.communication.ofCp)
    plan.connections.push_back({station, one.id, one.active,
                                one.port != 0 ? fmt::format("{}:{}", one.host, one.port) : one.host,
                                one.kind});
}

// Once for each station whose blocks name it.
void addConnection(const project::Network& network, const project::StationConnection& one,
                   NetworkPlan& plan) {
  const std::string& subnet = network.subnets[one.subnet].name;
  const auto at = [&](std::size_t station) {
    return fmt::format("{} ({})", network.stations[station].name, subnet);
  };
  plan.connections.push_back({one.local, one.id, true, at(one.partner), one.kind, true});
  if (one.partnerId)
    plan.connections.push_back({one.partner, *one.partnerId, false, at(one.local), one.kind, true});
}

}  // namespace

std::string_view kindName(ConnectionKind kind) {
  constexpr std::string_view kNames[] = {"s7", "tcp", "iso-on-tcp", "udp", "e-mail"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string nameOf(const PlannedConnection& connection) {
  constexpr std::string_view kNames[] = {"S7", "TCP", "ISO-on-TCP", "UDP", "E-mail"};
  const std::string_view kind = kNames[static_cast<std::size_t>(connection.kind)];
  return connection.kind == ConnectionKind::S7
             ? fmt::format("{} connection W#16#{:X}", kind, connection.id)
             : fmt::format("{} connection {}", kind, connection.id);
}

NetworkPlan planOf(const NetworkBuild& build) {
  const project::Network& network = *build.project.network;
  NetworkPlan plan;
  plan.name = build.project.name;
  for (const project::OtherStation& station : network.stations) {
    const Build* own = buildOf(build, station.name);
    plan.stations.push_back({station.name, station.folder, own != nullptr ? modelOf(*own) : ""});
    if (own != nullptr) addConnections(*own, plan.stations.size() - 1, plan);
  }
  for (const project::Subnet& subnet : network.subnets) plan.subnets.push_back(planned(subnet));
  for (const project::StationConnection& one : network.connections)
    addConnection(network, one, plan);
  plan.circles = network.globalData;
  return plan;
}

void addProfibus(const NetworkBuild& build, NetworkPlan& plan) {
  for (const project::DpSubnet& subnet : build.project.network->profibus)
    if (subnet.station) {
      plan.subnets.push_back(planned(subnet.master, *subnet.station));
      for (const project::IntelligentSlave& slave : subnet.intelligent) {
        const std::uint32_t address = slave.own.self.address;
        plan.subnets.back().nodes.push_back(
            {slave.station, address, {}, nameOf(subnet.master, address)});
      }
    }
}

NetworkPlan planOf(const Build& build) {
  const auto& hardware = build.project.hardware;
  NetworkPlan plan;
  plan.name = build.project.name;
  plan.stations.push_back({build.project.name, {}, modelOf(build)});
  if (hardware && hardware->dp) plan.subnets.push_back(planned(*hardware->dp, 0));
  addConnections(build, 0, plan);
  return plan;
}

}  // namespace merker::compilation
