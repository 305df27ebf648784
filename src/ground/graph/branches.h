// The rungs of a network as they hang on each other: what stands between two branches, then the
// paths that go on from there.
#pragma once

#include <memory>
#include <vector>

#include "graph/network.h"

namespace merker::graph {

struct Path {
  std::vector<Node> logic;  // none, or one; behind a branch its first contact `continues`
  std::vector<Coil> coils;
  std::vector<std::unique_ptr<Path>> tails;
  int depth = 0;  // branches that it stands in
};

std::vector<std::unique_ptr<Path>> paths(const Network& network);

// The contact in which the node begins: the first one of what stands first.
const Node* firstContact(const Node& node);

}  // namespace merker::graph
