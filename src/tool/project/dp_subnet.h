// A PROFIBUS-DP subnet: one master and its slaves.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/slave.h"

namespace merker::project {

// A [[slave]] that is another station of the project.
struct IntelligentSlave {
  std::size_t station = 0;  // its number in the list of stations
  Position named;
  io::OwnSlave own;
};

struct DpSubnet {
  std::string name;
  std::uint32_t highest = 126;         // PROFIBUS address (S7-NET-06)
  std::optional<std::size_t> station;  // whose DP interface is the master, in a list of stations
  Position named;                      // of the master
  Position position;
  io::DpMaster master;
  std::vector<IntelligentSlave> intelligent{};  // they are among the slaves of `master`
};

// Gives the station that is the master its slaves.
void plugSlaves(const DpSubnet& subnet, const CpuModel& model,
                std::optional<io::Configuration>& hardware, Problems& problems);

// Gives a station that is a slave its areas.
void plugOwnSlave(const IntelligentSlave& slave, const CpuModel& model,
                  std::optional<io::Configuration>& hardware, Problems& problems);

}  // namespace merker::project
