#include "network_routes.h"

namespace merker::app {

// PROFIBUS stands behind MPI; on Ethernet a client has other ways.
NetworkRoutes::NetworkRoutes(const project::Network& network) {
  for (const project::Subnet& subnet : network.subnets) {
    Line& line = lines_.emplace_back(Line{.name = subnet.name});
    const bool mpi = subnet.kind == project::SubnetKind::Mpi;
    for (const project::SubnetNode& node : subnet.nodes)
      line.stations.push_back({node.station, node.address, mpi});
  }
  // DP masters with subnets of the same name lie on one line.
  std::map<std::string, Line> profibus;
  for (const project::DpSubnet& subnet : network.profibus) {
    if (!subnet.station) continue;
    Line& line = profibus.try_emplace(subnet.name, Line{subnet.name, false}).first->second;
    line.stations.push_back({*subnet.station, subnet.master.address, true});
    for (const project::IntelligentSlave& slave : subnet.intelligent)
      line.stations.push_back({slave.station, slave.own.self.address, true});
  }
  for (auto& [name, line] : profibus) lines_.push_back(std::move(line));
}

// Stations that are on several subnets lead from one to the other. `passes`: a station is on the
// line, and hears it.
template <class Passes>
std::set<std::size_t> NetworkRoutes::spread(const Passes& passes) const {
  std::set<std::size_t> reached = {0};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const Line& line : lines_) {
      bool here = false;
      for (const Attached& one : line.stations)
        here |= reached.contains(one.station) && passes(line, one);
      for (const Attached& one : line.stations)
        if (here && passes(line, one)) reached.insert(one.station);
    }
  }
  return reached;
}

std::map<std::uint8_t, std::size_t> NetworkRoutes::stations() const {
  const auto reached = spread([](const Line&, const Attached&) { return true; });
  std::map<std::uint8_t, std::size_t> routes;
  for (const Line& line : lines_)
    for (const Attached& one : line.stations)
      if (one.named && one.address != 0 && reached.contains(one.station))
        routes.try_emplace(static_cast<std::uint8_t>(one.address), one.station);
  std::erase_if(routes, [](const auto& entry) { return entry.second == 0; });
  return routes;
}

// The bus of a DP master is its own: what it has of faults is between it and its slaves.
std::set<std::size_t> NetworkRoutes::reached(network::Network& plant) const {
  return spread([&](const Line& line, const Attached& one) {
    const controller::Controller& plc = plant.itself(one.station);
    if (!plc.powered()) return false;
    if (!line.telegrams) return true;
    const network::Subnet* const subnet = plant.subnet(line.name);
    return subnet != nullptr && !subnet->interrupted() &&
           !subnet->interrupted(static_cast<std::uint8_t>(one.address));
  });
}

}  // namespace merker::app
