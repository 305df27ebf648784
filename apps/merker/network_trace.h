// A trace of several stations: each is sampled on the thread that moves it, the lines are put in
// the order of virtual time, at the same instant in that of the stations.
#pragma once

#include <deque>
#include <optional>
#include <ostream>
#include <sstream>
#include <vector>

#include "network/network.h"
#include "operands.h"

namespace merker::app {

class NetworkTrace {
 public:
  // The values now are what the first changes are compared with. It must outlive the network's
  // runs.
  NetworkTrace(std::ostream& out, network::Network& network,
               const std::vector<StationWatched>& watched);
  // What happened before `end`.
  void write(Instant end);

 private:
  struct Line {
    Instant at;
    std::string text;
  };
  struct Column {
    std::ostringstream text;
    std::optional<simulator::Trace> trace;
    std::deque<Line> lines;
    void take(Instant at);
  };

  std::ostream& out_;
  std::deque<Column> columns_;  // they stay where they are
};

}  // namespace merker::app
