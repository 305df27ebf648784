// An MPI subnet in virtual time: one telegram after another, each as long as its bits.
#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "network/node.h"

namespace merker::network {

// Bits of a telegram with this much data on the line, with the pause in front of it (docs/
// compatibility.md, "Several stations").
constexpr std::int64_t telegramBits(std::size_t bytes) {
  constexpr std::int64_t kPause = 33;     // SYN of PROFIBUS (DIN 19245-1)
  constexpr std::int64_t kFrame = 9 + 2;  // SD2 LE LEr SD2 DA SA FC FCS ED, and two SAPs
  constexpr std::int64_t kPerByte = 11;   // start, 8 bits, parity, stop
  return kPause + kPerByte * (kFrame + static_cast<std::int64_t>(bytes));
}

class Subnet {
 public:
  // bits per second
  explicit Subnet(std::int64_t rate, std::string name = {}) : name_(std::move(name)), rate_(rate) {}
  const std::string& name() const { return name_; }

  Node& add(std::uint8_t address);
  Duration duration(std::int64_t bits) const;  // rounded up to a nanosecond
  // The least time between a telegram's sending and its arrival.
  Duration lookahead() const { return duration(telegramBits(1)); }
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
  std::int64_t rate_;
  bool interrupted_ = false;
  std::set<std::uint8_t> pulled_;
  Duration delay_{};
  Instant arrived_;  // the last one: none overtakes another when the delay becomes less
  std::vector<std::unique_ptr<Node>> nodes_;  // ascending addresses
  Instant free_;
  Duration busy_{};
};

}  // namespace merker::network
