// What the S7 server has refused and broken off since it began: how often, and the last causes, one
// for each address and reason.
#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <string>

#include "workbench/communication_view.h"

namespace merker::app {

struct S7Counts {
  std::atomic<std::uint64_t> connections = 0;  // that were confirmed
  std::atomic<std::uint64_t> refused = 0;      // sockets and connection requests
  std::atomic<std::uint64_t> broken = 0;       // ended because they broke the protocol or a limit
  std::atomic<std::uint64_t> requests = 0;
  std::atomic<std::uint64_t> denied = 0;  // of these, for want of a password, or for the setup
};

enum class S7Why : std::uint8_t {
  // connections that are refused
  NoResource,
  OtherSlot,
  NoSocket,
  NoPower,
  NoWay,
  // connections that are broken off
  WrongTransport,
  NoS7,
  TooLate,
  ReadsNothing,
  MadeRoom,
  // requests that are denied
  Protected,
  WrongPassword,
  WrongSetup
};

// In the thread of the server, but for the counts.
class S7Incidents {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMost = 16;  // remembered

  S7Counts counts{};

  void note(const std::string& address, S7Why why, Clock::time_point now = Clock::now());
  // The latest first.
  std::vector<workbench::S7RefusedRow> rows(Clock::time_point now) const;

 private:
  struct Incident {
    std::string address;
    S7Why why;
    std::uint64_t times = 0;
    Clock::time_point last{};
  };
  std::deque<Incident> incidents_;
};

}  // namespace merker::app
