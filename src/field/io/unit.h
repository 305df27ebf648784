// One module in operation: what lies at its terminals, what it delivers, what is wrong with it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "clock/instant.h"
#include "io/fault.h"
#include "signal/signal.h"

namespace merker::io {

constexpr std::uint16_t bitOf(FaultKind kind) {
  return static_cast<std::uint16_t>(1u << static_cast<unsigned>(kind));
}

struct Unit {
  Unit() {
    levelDue.fill(Instant::never());
    amountDue.fill(Instant::never());
  }

  // digital inputs: terminals, what the input delay has let through, when it lets the rest through
  std::uint32_t levels = 0, delivered = 0;
  std::array<Instant, 32> levelDue;
  // Signals that are known in advance, by channel; `seen`: until when they have been looked at.
  struct Attached {
    std::shared_ptr<const signal::Signal> signal;
    Instant since, seen;
  };
  std::map<std::uint32_t, Attached> signals;
  std::uint32_t watched = 0;                   // whose edges `technology` wants
  std::uint32_t driven = 0, drivenLevels = 0;  // digital outputs that it drives
  // analog inputs: terminals, what the last conversion gave, when the next one ends
  std::array<double, 8> amounts{};
  std::array<std::int16_t, 8> shown{};
  std::array<Instant, 8> amountDue;
  std::uint32_t beyond = 0;  // bits as in POINT_ADDR: limits that are exceeded now

  std::uint16_t moduleFaults = 0;                  // bitOf
  std::array<std::uint16_t, 32> channelFaults{};   // that were put there
  std::array<std::uint16_t, 32> measuredFaults{};  // that the module sees in its values
  std::vector<std::uint8_t> diagnosis;             // data record 1, as last reported

  bool has(FaultKind kind) const { return (moduleFaults & bitOf(kind)) != 0; }
  bool hasAnywhere(FaultKind kind) const {
    return has(kind) || std::any_of(channelFaults.begin(), channelFaults.end(),
                                    [&](auto faults) { return (faults & bitOf(kind)) != 0; });
  }
  std::uint16_t faultsOf(std::uint32_t channel) const {
    return static_cast<std::uint16_t>(channelFaults[channel] | measuredFaults[channel]);
  }
  bool has(std::uint32_t channel, FaultKind kind) const {
    return (faultsOf(channel) & bitOf(kind)) != 0;
  }
};

}  // namespace merker::io
