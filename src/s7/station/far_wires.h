// Wires between a plant of one station and terminals of another one. Each side tells the other what
// its end shows when that changes; it arrives later than it left, so that stations can move through
// time side by side.
#pragma once

#include <vector>

#include "io/rack.h"
#include "network/node.h"
#include "plant/plants.h"

namespace merker::station {

class FarWires {
 public:
  FarWires(io::Rack& rack, plant::Plants& plants) : rack_(rack), plants_(plants) {}

  // All wires between this station and its partner that belong to plants of the one or the other;
  // tells and hears what they show before time begins.
  void join(network::Node& node, std::size_t partner, bool plant);
  bool any() const { return !bundles_.empty(); }
  Instant next() const;  // when something arrives
  void hear(Instant now);
  void look(Instant now);

 private:
  // The end of a wire on this side.
  struct End {
    std::uint32_t number = 0;  // of the wire, on both sides
    bool plant = false;        // of a plant; else `terminal`
    io::Terminal terminal{};
    bool tells = false;
    double told = 0;
  };
  struct Bundle {
    network::Node* node;
    std::vector<End> ends;
  };
  std::vector<End> endsOfPlants(std::size_t partner) const;
  std::vector<End> endsOfTerminals(std::size_t partner) const;
  double shown(const End& end) const;
  void take(const End& end, double value, Instant at);
  void tell(Bundle& bundle, Instant now);

  io::Rack& rack_;
  plant::Plants& plants_;
  std::vector<Bundle> bundles_;
};

}  // namespace merker::station
