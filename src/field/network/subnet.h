// A subnet, MPI or Ethernet, in virtual time: one telegram after another, each as long as its bits.
#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "network/medium.h"
#include "network/node.h"

namespace merker::network {

class Subnet {
 public:
  explicit Subnet(const Medium& medium, std::string name = {})
      : name_(std::move(name)), medium_(medium) {}
  // MPI; bits per second
  explicit Subnet(std::int64_t rate, std::string name = {}) : Subnet(mpi(rate), std::move(name)) {}
  const std::string& name() const { return name_; }

  Node& add(std::uint8_t address);
  Duration duration(std::int64_t bits) const;  // rounded up to a nanosecond
  // The least time between a telegram's sending and its arrival.
  Duration lookahead() const { return duration(telegramBits(medium_, 1)) + medium_.latency; }
  // Everything that was sent before `end` is known now: on the line in the order of virtual time,
  // at the same instant the lower address first, whenever the line is free.
  void carry(Instant end);
  // How long the line was busy so far.
  Duration busy() const { return busy_; }

  // Faults of the line, for what is sent from now on; what is on it arrives. The whole line is
  // broken or shorted: nobody reaches anybody.
  void interrupt() { interrupted_ = true; }
  // The plug of this station is pulled; the others reach each other.
  void interrupt(std::uint8_t address) { pulled_.insert(address); }
  // Telegrams arrive so much later, as over a slow coupling between two segments.
  void delay(Duration time) { delay_ = time; }
  void mend();
  void mend(std::uint8_t address) { pulled_.erase(address); }
  bool interrupted() const { return interrupted_; }
  bool interrupted(std::uint8_t address) const { return pulled_.contains(address); }
  Duration delayed() const { return delay_; }

 private:
  bool reaches(std::uint8_t from, std::uint8_t to) const;
  void deliver(Node& node, Telegram telegram);
  void put(Telegram telegram);
  Node* find(std::uint8_t address);
  Instant occupy(Instant from, std::int64_t bits);

  std::string name_;
  Medium medium_;
  bool interrupted_ = false;
  std::set<std::uint8_t> pulled_;
  Duration delay_{};
  Instant arrived_;  // the last one: none overtakes another when the delay becomes less
  std::vector<std::unique_ptr<Node>> nodes_;  // ascending addresses
  Instant free_;
  Duration busy_{};
};

}  // namespace merker::network
