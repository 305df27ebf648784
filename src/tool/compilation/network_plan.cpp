#include "compilation/network_plan.h"

#include <fmt/format.h>

#include <algorithm>

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

std::string rateText(const project::Subnet& subnet) {
  constexpr std::int64_t kMega = 1'000'000;
  return subnet.rate >= kMega ? fmt::format("{} Mbit/s", subnet.rate / kMega)
                              : fmt::format("{} kbit/s", static_cast<double>(subnet.rate) / 1000);
}

PlannedSubnet planned(const project::Subnet& subnet) {
  const bool ethernet = subnet.kind == project::SubnetKind::Ethernet;
  PlannedSubnet result{
      subnet.name,    ethernet ? "ethernet" : "mpi", rateText(subnet), subnet.highest, {},
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
}

// Once for each station whose blocks name it.
void addConnection(const project::Network& network, const project::StationConnection& one,
                   NetworkPlan& plan) {
  const std::string& subnet = network.subnets[one.subnet].name;
  const auto at = [&](std::size_t station) {
    return fmt::format("{} ({})", network.stations[station].name, subnet);
  };
  plan.connections.push_back({one.local, one.id, true, at(one.partner)});
  if (one.partnerId)
    plan.connections.push_back({one.partner, *one.partnerId, false, at(one.local)});
}

}  // namespace

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

}  // namespace merker::compilation
