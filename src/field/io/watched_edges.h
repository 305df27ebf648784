// Edges of the inputs that channels of `technology` and `positioning` watch, until each has taken
// its own.
#pragma once

#include <array>
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

enum class Watcher : std::uint8_t { Counting, Positioning };

class WatchedEdges {
 public:
  explicit WatchedEdges(std::size_t modules) {
    for (One& one : watchers_) one.watched.resize(modules);
  }

  void watch(Watcher who, Terminal input) { of(who).watched[input.module] |= 1u << input.channel; }
  void note(const Edge& edge) {
    for (One& one : watchers_)
      if ((one.watched[edge.terminal.module] >> edge.terminal.channel & 1) != 0)
        one.edges.push_back(edge);
  }
  bool any() const { return !watchers_[0].edges.empty() || !watchers_[1].edges.empty(); }
  std::vector<Edge> take(Watcher who) { return std::exchange(of(who).edges, {}); }

 private:
  struct One {
    std::vector<std::uint32_t> watched;  // channels by module
    std::vector<Edge> edges;
  };
  One& of(Watcher who) { return watchers_[static_cast<std::size_t>(who)]; }

  std::array<One, 2> watchers_;
};

}  // namespace merker::io
