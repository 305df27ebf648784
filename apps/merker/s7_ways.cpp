#include "s7_ways.h"

#include <fmt/format.h>

#include <iostream>

namespace merker::app {

void S7Ways::lay(const compilation::NetworkBuild& build, const std::vector<S7Server*>& servers) {
  constexpr unsigned kSlots = 32;
  routes_.emplace(*build.project.network);
  open_.clear();
  for (std::size_t i = 0; i < build.stations.size(); ++i)
    open_.push_back(std::make_shared<std::atomic<bool>>(true));
  std::map<std::uint8_t, S7Way> ways;
  for (const auto& [address, station] : routes_->stations()) {
    if (station >= servers.size()) continue;
    ways[address] = {servers[station], open_[station]};
    std::cerr << fmt::format("{} at {}, too: rack {}, slot {} (address {})\n",
                             build.stations[station].name, servers.front()->place(),
                             address / kSlots, address % kSlots, address);
  }
  servers.front()->passOn(std::move(ways));
}

void S7Ways::look(network::Network& plant) {
  if (!routes_) return;
  const std::set<std::size_t> reached = routes_->reached(plant);
  for (std::size_t i = 0; i < open_.size(); ++i) *open_[i] = reached.contains(i);
}

}  // namespace merker::app
