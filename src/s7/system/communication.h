// What the system status list says of connections (16#0131, 16#0132): what is set, and how many are
// in use; and of the interface they come by (16#0037). A server of S7 communication keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>

#include "catalogue/communication.h"
#include "cpu/leds.h"

namespace merker::system {

struct EthernetInterface {
  std::array<std::uint8_t, 4> address{}, mask{};
  std::array<std::uint8_t, 6> hardware{};  // MAC
};

struct Communication {
  CommunicationParameters parameters{};
  std::array<std::uint32_t, 3> used{};  // PG, OP, others
  std::uint32_t testJobs = 0;           // of test and installation
  std::optional<EthernetInterface> ethernet{};
  bool flashing = false;  // FRCE, for a programming device that looks for the CPU

  cpu::Leds seen(cpu::Leds leds) const {
    if (flashing && leds.dc5v == cpu::Light::On) leds.frce = cpu::Light::Fast;
    return leds;
  }

  // A number for what has no limit, as the lists have 16 bits.
  std::uint32_t connections() const { return parameters.connections.value_or(0xFFFF); }
  std::uint32_t inUse() const { return std::accumulate(used.begin(), used.end(), 0u); }
};

}  // namespace merker::system
