// Connections of a CP 343-1 for AG_SEND and AG_RECV as the program has them (S7-SFB-10): what it
// sends stays here until the end of the cycle, what has come until the program takes it. Whoever
// carries both is not known here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "catalogue/communication.h"

namespace merker::system {

class SendReceive {
 public:
  using Bytes = std::vector<std::uint8_t>;
  // Octets of a job, as users of these blocks know them, and of what waits for AG_RECV, which is
  // our own: docs/compatibility.md.
  static constexpr std::size_t kLongest = 8192, kLongestDatagram = 2048;
  static constexpr std::size_t kMostWaiting = 4 * kLongest, kMostTelegrams = 64;
  static constexpr std::uint16_t kSent = 0, kNotTaken = 0x8302, kNoConnection = 0x8304;

  struct Connection {
    std::uint8_t id = 1;
    ConnectionKind kind = ConnectionKind::Tcp;
    bool up = false;
    bool sends = false;          // AG_SEND has begun a job, and has not told its result
    std::optional<Bytes> out{};  // of the job, until somebody carries it
    std::optional<std::uint16_t> result{};
    std::deque<Bytes> in{};
    std::size_t waiting = 0;  // octets in `in`

    bool isStream() const { return kind == ConnectionKind::Tcp; }
    std::size_t longest() const {
      return kind == ConnectionKind::Udp ? kLongestDatagram : kLongest;
    }
    bool hasRoom(std::size_t octets) const {
      return in.size() < kMostTelegrams && waiting + octets <= kMostWaiting;
    }
  };

  void configure(const std::vector<CpConnectionParameters>& connections);
  // One more, behind them; its place.
  std::size_t add(std::uint8_t id, ConnectionKind kind);
  // The program begins anew.
  void restart();

  // Of the blocks. Null: the project has none with this ID.
  Connection* find(std::uint32_t id);
  static void begin(Connection& one, Bytes data);
  // The oldest telegram; of a stream so many octets, which are there.
  static Bytes take(Connection& one, std::size_t octets);

  // Of whoever carries them, at the end of a cycle.
  std::size_t count() const { return connections_.size(); }
  Connection& at(std::size_t place) { return connections_[place]; }
  static void connected(Connection& one, bool is);
  static void ended(Connection& one, std::uint16_t result);
  // False: there is no room, it is lost.
  static bool arrived(Connection& one, Bytes data);

 private:
  std::vector<Connection> connections_;
};

}  // namespace merker::system
