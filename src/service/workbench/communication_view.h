// Clients of S7 communication as people see them: who is connected, who was refused and why, and
// who could come. The program around says it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/json.h"

namespace merker::workbench {

struct S7ClientRow {
  std::string partner;  // "127.0.0.1:40112"
  std::string kind;     // "PG", "OP", "other"
  std::uint32_t pdu = 0;
  std::int64_t seconds = 0;                                      // since it was confirmed
  std::uint64_t requests = 0, received = 0, sent = 0, lost = 0;  // octets; indications
};

// What was refused to an address, or why its connections were broken off.
struct S7RefusedRow {
  std::string partner;  // "127.0.0.1"
  std::string why;      // a code of docs/workbench-protocol.md, S7Refusal
  std::uint64_t times = 0;
  std::int64_t seconds = 0;  // ago, the last one
};

// A configured connection of this PLC.
struct S7PartnerRow {
  std::string id;          // "W#16#1"
  std::string host;        // of the partner
  std::uint32_t port = 0;  // there; 0: it is the partner that calls
  bool active = false;     // this side calls
  std::string state;       // "connected"; "calls", "waits"; "outside": must not be called
  std::uint32_t pdu = 0;
};

// A connection of a CP 343-1 that somebody carries.
struct CpConnectionRow {
  std::uint8_t id = 1;
  bool connected = false;
};

struct S7Outside {
  std::string place{};                         // "127.0.0.1:10102"; empty: nobody is served
  std::string warning{};                       // other computers can come; empty: they cannot
  std::optional<std::uint32_t> connections{};  // none: unlimited
  std::uint32_t pg = 0, op = 0, basic = 0;     // kept for a kind
  std::uint64_t confirmed = 0, refused = 0, broken = 0, requests = 0, denied = 0;
  std::vector<S7ClientRow> clients{};
  std::vector<S7PartnerRow> partners{};
  std::vector<CpConnectionRow> ofCp{};
  std::vector<S7RefusedRow> refusals{};  // the last ones, newest first
};

Json s7Json(const S7Outside& outside);

}  // namespace merker::workbench
