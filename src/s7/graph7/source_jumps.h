// Labels of a block and the jumps to them, in a source text.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "graph/source_network.h"

namespace merker::graph7 {

class Labels {
 public:
  // A label stands before the next statement, a jump is the last one so far.
  void add(std::string_view name, const std::vector<graph::SourceNetwork>& networks);
  void jump(const std::vector<graph::SourceNetwork>& networks);

  // Of all networks: where jumps lead, and which statements they lead into.
  void resolve(std::vector<graph::SourceNetwork>& networks) const;

 private:
  struct Place {
    std::size_t network = 0, statement = 0;
  };
  static Place following(Place place, const std::vector<graph::SourceNetwork>& networks);

  std::map<std::string, Place, std::less<>> labels_;
  std::vector<Place> jumps_;
};

}  // namespace merker::graph7
