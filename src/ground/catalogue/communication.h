// How many connections a CPU has (S7-LIM-05), and what a project sets of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "address/connection_kind.h"
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

// A connection of a CP 343-1 to a partner outside, for AG_SEND and AG_RECV (S7-SFB-10).
struct CpConnectionParameters {
  static constexpr std::uint32_t kHighestId = 16;  // S7-300
  static constexpr std::size_t kLongestTsap = 16;  // octets

  std::uint8_t id = 1;
  ConnectionKind kind = ConnectionKind::Tcp;
  std::string host = "127.0.0.1";  // of the partner, as a number
  std::uint16_t port = 0;          // there, if this side calls; of UDP always
  std::uint16_t localPort = 0;     // where this side listens, if it is called; of UDP always
  bool active = true;              // this side calls
  std::vector<std::uint8_t> localTsap{}, partnerTsap{};  // ISO on TCP
  std::string sender{};                                  // of e-mails that name none
  bool operator==(const CpConnectionParameters&) const = default;
};

// The web server of a CP 343-1 IT (S7-NET-16).
struct CpWebParameters {
  std::string slot;        // of the CP, as the hardware configuration has it
  std::uint16_t port = 0;  // of this computer
  std::string folder{};    // of the user's pages; empty: there are none
  bool operator==(const CpWebParameters&) const = default;
};

struct CommunicationParameters {
  std::optional<std::uint32_t> connections;  // none: unlimited
  std::uint32_t pg = 1, op = 1, basic = 0;   // of these kept for one kind
  std::uint16_t pdu = 240;                   // octets (S7-LIM-01)
  bool strictSlot = false;                   // the called TSAP names rack 0, slot 2, or is refused
  std::string address{};                     // of the server, as --s7 takes it; empty: none
  std::vector<ConnectionParameters> configured{};
  std::vector<CpConnectionParameters> ofCp{};
  std::vector<CpWebParameters> web{};
  bool operator==(const CommunicationParameters&) const = default;

  static CommunicationParameters of(const CpuModel& model) {
    CommunicationParameters parameters;
    parameters.connections = connectionLimits(model).connections;
    return parameters;
  }
};

}  // namespace merker
