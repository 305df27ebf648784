// How many connections a CPU has (S7-LIM-05), and what a project sets of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/cpu_model.h"

namespace merker {

// Of all connections of a CPU. What is usable for S7 basic communication at most.
struct ConnectionLimits {
  std::uint32_t connections = 12, basic = 8;
};
ConnectionLimits connectionLimits(const CpuModel& model);

// A configured S7 connection (S7-NETPRO-08).
struct ConnectionParameters {
  static constexpr std::uint16_t kHighestId = 0xFFF;
  using Tsap = std::array<std::uint8_t, 2>;  // connection resource; rack * 32 + slot

  std::uint16_t id = 1;            // as blocks of this station name it
  std::string host = "127.0.0.1";  // of the partner, as a number
  std::uint16_t port = 102;        // there, if this side calls
  bool active = true;              // this side calls
  Tsap local{0x10, 2}, partner{0x10, 2};
  bool operator==(const ConnectionParameters&) const = default;
};

struct CommunicationParameters {
  std::optional<std::uint32_t> connections;  // none: unlimited
  std::uint32_t pg = 1, op = 1, basic = 0;   // of these kept for one kind
  std::uint16_t pdu = 240;                   // octets (S7-LIM-01)
  bool strictSlot = false;                   // the called TSAP names rack 0, slot 2, or is refused
  std::string address{};                     // of the server, as --s7 takes it; empty: none
  std::vector<ConnectionParameters> configured{};
  bool operator==(const CommunicationParameters&) const = default;

  static CommunicationParameters of(const CpuModel& model) {
    CommunicationParameters parameters;
    parameters.connections = connectionLimits(model).connections;
    return parameters;
  }
};

}  // namespace merker
