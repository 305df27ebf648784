// What a project of several stations holds, as far as it could be read: for drawings and lists.
#pragma once

#include <string>
#include <vector>

#include "compilation/network.h"

namespace merker::compilation {

struct PlannedNode {
  std::size_t station = 0;
  std::uint32_t address = 0;
  std::string ip{};     // on Ethernet
  std::string slave{};  // an intelligent slave: its name there
};

// Of a DP master.
struct PlannedSlave {
  std::uint32_t address = 0;
  std::string name, model;
};

struct PlannedSubnet {
  std::string name, kind;  // kind: as in merker.toml
  std::string rate;        // "187.5 kbit/s"
  std::uint32_t highest = 0;
  std::vector<PlannedNode> nodes;  // ascending addresses
  std::vector<project::Segment> segments;
  std::vector<PlannedSlave> slaves{};
};

struct PlannedStation {
  std::string name, folder, model;  // model: empty if its folder could not be read
};

struct PlannedConnection {
  std::size_t station = 0;
  std::uint16_t id = 1;
  bool active = true;
  std::string partner;  // "127.0.0.1:10102"
  ConnectionKind kind = ConnectionKind::S7;
  bool inside = false;  // the partner is another station of the project
};

// "s7", as in merker.toml; "S7 connection W#16#1", "TCP connection 1".
std::string_view kindName(ConnectionKind kind);
std::string nameOf(const PlannedConnection& connection);

struct NetworkPlan {
  std::string name;
  std::vector<PlannedStation> stations;
  std::vector<PlannedSubnet> subnets;
  std::vector<project::GlobalDataRow> circles;
  std::vector<PlannedConnection> connections;
};

NetworkPlan planOf(const NetworkBuild& build);
// PROFIBUS behind the other subnets: masters and their slaves.
void addProfibus(const NetworkBuild& build, NetworkPlan& plan);
// The same of a project of one station.
NetworkPlan planOf(const Build& build);

}  // namespace merker::compilation
