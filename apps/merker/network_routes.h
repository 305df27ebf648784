// Which stations a client reaches through the S7 server of the first one (S7-NET-15): the low byte
// of the called TSAP, rack * 32 + slot, is then an MPI or PROFIBUS address.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "network/network.h"
#include "project/network.h"

namespace merker::app {

class NetworkRoutes {
 public:
  explicit NetworkRoutes(const project::Network& network);

  // Numbers of stations by address. Those that no subnets lead to from the first one are not in it;
  // an address that several have is that of the first in the order of the file. The first station
  // is reached without it.
  std::map<std::uint8_t, std::size_t> stations() const;
  // Which ones can be reached now: the line of each subnet on the way is whole, its plugs are in,
  // and the stations have power.
  std::set<std::size_t> reached(network::Network& plant) const;

 private:
  struct Attached {
    std::size_t station;
    std::uint32_t address;
    bool named;  // a TSAP can name it
  };
  struct Line {
    std::string name;
    bool telegrams = true;  // a subnet of network::Network
    std::vector<Attached> stations{};
  };
  template <class Passes>
  std::set<std::size_t> spread(const Passes& passes) const;

  std::vector<Line> lines_;
};

}  // namespace merker::app
