// The subnets of several stations as the network view and the hardware view change them
// (S7-NETPRO-02 to -04, -06).
#pragma once

#include <string>

#include "base/result.h"

namespace merker::workbench {

struct NodeChange {
  std::string subnet, station;
  std::string address;  // "3", "192.168.0.3"; empty: it leaves the subnet
};

struct SubnetChange {
  std::string name, kind;     // kind: of a new one, "mpi", "ethernet" or "profibus"
  std::string master;         // of a new PROFIBUS subnet: the station that is its DP master
  std::string baud;           // as in merker.toml; empty: as it is
  std::uint32_t highest = 0;  // 0: as it is
  bool remove = false;
};

// `path`: of the project. Both give it back; what is wrong leaves the file as it was.
Result<std::string> changeNode(const std::string& path, const NodeChange& wanted);
Result<std::string> changeSubnet(const std::string& path, const SubnetChange& wanted);

}  // namespace merker::workbench
