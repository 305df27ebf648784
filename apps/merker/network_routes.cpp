#include "network_routes.h"

#include <set>
#include <vector>

namespace merker::app {
namespace {

struct Attached {
  std::size_t station;
  std::uint32_t address;  // 0: it has none that a TSAP could name
};
using Line = std::vector<Attached>;

// PROFIBUS stands behind MPI; on Ethernet a client has other ways.
std::vector<Line> linesOf(const project::Network& network) {
  std::vector<Line> lines;
  for (const project::Subnet& subnet : network.subnets) {
    Line& line = lines.emplace_back();
    const bool mpi = subnet.kind == project::SubnetKind::Mpi;
    for (const project::SubnetNode& node : subnet.nodes)
      line.push_back({node.station, mpi ? node.address : 0});
  }
  // DP masters with subnets of the same name lie on one line.
  std::map<std::string, Line> profibus;
  for (const project::DpSubnet& subnet : network.profibus)
    if (subnet.station) profibus[subnet.name].push_back({*subnet.station, subnet.master.address});
  for (auto& [name, line] : profibus) lines.push_back(std::move(line));
  return lines;
}

// Stations that are on several subnets lead from one to the other.
std::set<std::size_t> reachedFrom(std::size_t first, const std::vector<Line>& lines) {
  std::set<std::size_t> reached = {first};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const Line& line : lines) {
      bool here = false;
      for (const Attached& one : line) here |= reached.contains(one.station);
      for (const Attached& one : line)
        if (here) reached.insert(one.station);
    }
  }
  return reached;
}

}  // namespace

std::map<std::uint8_t, std::size_t> routesOf(const project::Network& network) {
  const std::vector<Line> lines = linesOf(network);
  const std::set<std::size_t> reached = reachedFrom(0, lines);
  std::map<std::uint8_t, std::size_t> routes;
  for (const Line& line : lines)
    for (const Attached& one : line)
      if (one.address != 0 && reached.contains(one.station))
        routes.try_emplace(static_cast<std::uint8_t>(one.address), one.station);
  std::erase_if(routes, [](const auto& entry) { return entry.second == 0; });
  return routes;
}

}  // namespace merker::app
