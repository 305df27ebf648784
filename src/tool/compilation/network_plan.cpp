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

PlannedSubnet planned(const project::MpiSubnet& subnet) {
  PlannedSubnet result{
      subnet.name,    "mpi", fmt::format("{} kbit/s", static_cast<double>(subnet.rate) / 1000),
      subnet.highest, {},    subnet.segments};
  for (const project::SubnetNode& node : subnet.nodes)
    result.nodes.push_back({node.station, node.address});
  std::ranges::sort(result.nodes, {}, &PlannedNode::address);
  return result;
}

void addConnections(const Build& build, std::size_t station, NetworkPlan& plan) {
  for (const ConnectionParameters& one : build.project.communication.configured)
    plan.connections.push_back({station, one.id, one.active,
                                one.active ? fmt::format("{}:{}", one.host, one.port) : one.host});
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
  for (const project::MpiSubnet& subnet : network.subnets) plan.subnets.push_back(planned(subnet));
  plan.circles = network.globalData;
  return plan;
}

}  // namespace merker::compilation
