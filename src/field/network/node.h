// A station on a subnet: what it sends, and what has arrived for it. Only the thread that moves the
// station and, between two windows of time, the subnet touch it.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "clock/instant.h"
#include "network/connection.h"
#include "network/global_data.h"
#include "plc/capability.h"

namespace merker::network {

// To all nodes of the subnet (PROFIBUS, MPI).
constexpr std::uint8_t kEveryone = 127;

struct Telegram {
  Instant at;  // when it was given to the subnet; at the receiver: when its last bit was there
  std::uint8_t from = 0, to = 0;
  std::vector<std::uint8_t> data;  // at the sender empty: there is nobody with the address `from`
};

class Node {
 public:
  explicit Node(std::uint8_t address) : address_(address) {}
  std::uint8_t address() const { return address_; }

  // Instants of one station never go back.
  void send(Instant at, std::uint8_t to, std::vector<std::uint8_t> data) {
    out_.push_back({at, address_, to, std::move(data)});
  }
  // When the next one arrives, as far as that is known; never: none is on the way.
  Instant next() const { return in_.empty() ? Instant::never() : in_.front().at; }
  // Nothing was sent that is not on the line yet, and nothing is on the way to it.
  bool idle() const { return in_.empty() && out_.empty(); }
  // The next one that is there by `now`; it is taken.
  std::optional<Telegram> receive(Instant now);

  // For the subnet: what was sent before `end`, and what arrives, later than all before it.
  std::vector<Telegram> takeSent(Instant end);
  void deliver(Telegram telegram) { in_.push_back(std::move(telegram)); }

 private:
  std::uint8_t address_;
  std::deque<Telegram> out_, in_;
};

// A PLC that can be a node of subnets.
class Connectable : public controller::Capability {
 public:
  static constexpr std::string_view kName = "MPI interface";

  // The node outlives the PLC.
  virtual void join(Node& node, const GlobalData& globalData) = 0;
  // Its DP interface, where it exchanges data with other stations: as their master, or as a slave.
  virtual void joinDp(Node& node) = 0;
  // Wires between a plant and the terminals of another station, the `partner`. `plant`: it is this
  // one's.
  virtual void joinWires(Node& node, std::size_t partner, bool plant) = 0;
  // One more configured connection, over any subnet.
  virtual void connect(const ConnectionEnd& end) = 0;
  // False: it sends nothing before a telegram reaches it or somebody changes its program. Then the
  // others need not wait for it.
  virtual bool maySend() const = 0;
};

}  // namespace merker::network
