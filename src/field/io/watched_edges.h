// Edges of the inputs that channels of `technology` watch, until they are taken.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "clock/instant.h"
#include "io/terminal.h"
#include "signal/signal.h"

namespace merker::io {

// What changed at a terminal that is watched: its level, and the signal that lies there from then
// on, if any.
struct Edge {
  Terminal terminal;
  bool level = false;
  Instant at;
  std::shared_ptr<const signal::Signal> signal;
};

class WatchedEdges {
 public:
  explicit WatchedEdges(std::size_t modules) : watched_(modules) {}

  void watch(Terminal input) { watched_[input.module] |= 1u << input.channel; }
  void note(Edge edge) {
    if ((watched_[edge.terminal.module] >> edge.terminal.channel & 1) != 0)
      edges_.push_back(std::move(edge));
  }
  bool any() const { return !edges_.empty(); }
  std::vector<Edge> take() { return std::exchange(edges_, {}); }

 private:
  std::vector<std::uint32_t> watched_;  // channels by module
  std::vector<Edge> edges_;
};

}  // namespace merker::io
