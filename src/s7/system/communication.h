// What the system status list says of connections (16#0131, 16#0132): what is set, and how many are
// in use. A server of S7 communication keeps the numbers.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "catalogue/communication.h"

namespace merker::system {

struct Communication {
  CommunicationParameters parameters{};
  std::array<std::uint32_t, 3> used{};  // PG, OP, others
  std::uint32_t testJobs = 0;           // of test and installation

  // A number for what has no limit, as the lists have 16 bits.
  std::uint32_t connections() const { return parameters.connections.value_or(0xFFFF); }
  std::uint32_t inUse() const { return std::accumulate(used.begin(), used.end(), 0u); }
};

}  // namespace merker::system
