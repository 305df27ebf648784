// The ways from the S7 server of the first station to the others (S7-NET-15), as the lines between
// them are now.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "compilation/network.h"
#include "network_routes.h"
#include "s7_server.h"

namespace merker::app {

class S7Ways {
 public:
  // `servers`: of the stations, in their order; they outlive the first one. What is reached how is
  // told.
  void lay(const compilation::NetworkBuild& build, const std::vector<S7Server*>& servers);
  // In the thread of the stations.
  void look(network::Network& plant);

 private:
  std::optional<NetworkRoutes> routes_;
  std::vector<std::shared_ptr<std::atomic<bool>>> open_;  // by station
};

}  // namespace merker::app
