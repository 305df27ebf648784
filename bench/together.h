// Many stations in one process that no subnet connects, moved as `merker run` moves them: on two
// threads, each alone for as long as nobody can reach it.
#pragma once

#include <functional>

#include "network/network.h"
#include "station/station.h"

namespace merker::bench {

class Together {
 public:
  Together(std::size_t count, const std::function<station::Station()>& make);

  void advance(Duration by) { network_.advanceTo(network_.now() + by); }
  station::Station& station(std::size_t i);

 private:
  network::Network network_;
};

}  // namespace merker::bench
