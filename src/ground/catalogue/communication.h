// How many connections a CPU has (S7-LIM-05), and what a project sets of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "catalogue/cpu_model.h"

namespace merker {

// Of all connections of a CPU. What is usable for S7 basic communication at most.
struct ConnectionLimits {
  std::uint32_t connections = 12, basic = 8;
};
ConnectionLimits connectionLimits(const CpuModel& model);

struct CommunicationParameters {
  std::optional<std::uint32_t> connections;  // none: unlimited
  std::uint32_t pg = 1, op = 1, basic = 0;   // of these kept for one kind
  std::uint16_t pdu = 240;                   // octets (S7-LIM-01)
  bool strictSlot = false;                   // the called TSAP names rack 0, slot 2, or is refused
  std::string address{};                     // of the server, as --s7 takes it; empty: none
  bool operator==(const CommunicationParameters&) const = default;

  static CommunicationParameters of(const CpuModel& model) {
    CommunicationParameters parameters;
    parameters.connections = connectionLimits(model).connections;
    return parameters;
  }
};

}  // namespace merker
