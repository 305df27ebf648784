// The DP interface of a station towards other stations of the project: as the master of intelligent
// slaves, or as one. Each tells the other whether it is there and executes its program, and what
// its outputs are; the other one's inputs show them.
#pragma once

#include <cstdint>
#include <vector>

#include "io/rack.h"
#include "network/node.h"
#include "profibus/exchange.h"

namespace merker::station {

class DpInterface {
 public:
  DpInterface(io::Rack& rack, const profibus::Exchange& exchange);

  // The node outlives it.
  void join(network::Node& node) { node_ = &node; }
  bool joined() const { return node_ != nullptr; }

  // When something arrives, or an intelligent slave has its turn and something to hear.
  Instant next() const;
  // What has arrived by `now` goes to the inputs.
  void hear(Instant now);
  // What is due by `now` goes out.
  void advance(Instant now);
  // The program has written there.
  void written(std::uint32_t first, std::uint32_t count, Instant now);
  // Outputs or state may be others than a moment ago.
  void changed(Instant now);
  void supply(bool on, Instant now);
  void execute(bool does, bool powered, Instant now);

 private:
  struct Partner {
    std::uint8_t address = 0;
    std::uint32_t head = 0;                      // modules of the configuration
    std::vector<std::uint32_t> inputs, outputs;  // the same
    std::optional<std::size_t> slave{};          // of the master: whose turn it is
    std::vector<std::uint8_t> said{}, heard{};   // heard: not taken yet
    bool stopped = false;
    Instant due = Instant::never();
  };
  void add(std::uint8_t address, const io::Slave& slave, std::optional<std::size_t> turn);
  void take(Partner& partner);
  void say(Partner& partner, Instant now);
  std::vector<std::uint8_t> telegram(const Partner& partner) const;

  io::Rack& rack_;
  const profibus::Exchange& exchange_;
  network::Node* node_ = nullptr;
  std::vector<Partner> partners_;
  bool supplied_ = true, executes_ = true;
};

}  // namespace merker::station
