// Finds in a network what is named from outside.
#pragma once

#include <optional>

#include "graph/network.h"
#include "graph/selection.h"

namespace merker::graph {

// A node by its place in a list of nodes.
struct Step {
  std::vector<Node>* list = nullptr;
  std::size_t at = 0;
  Node& node() const { return (*list)[at]; }
};

// A coil; or nodes beside each other: one, or some of a series.
struct Location {
  Rung* rung = nullptr;
  Coil* coil = nullptr;
  std::vector<Node>* list = nullptr;  // in which the nodes stand
  std::size_t from = 0, count = 1;
  Node* parent = nullptr;         // whose list it is; none: the rung's
  std::vector<Step> around = {};  // the nodes that it stands in, the outermost first

  Node& node() const { return (*list)[from]; }
  std::size_t end() const { return from + count; }
  bool inSeries() const {
    return parent != nullptr && parent->kind == NodeKind::Series && list == &parent->children;
  }
};

std::optional<Location> locate(Network& network, const Selection& selection);
// All of the logic of a rung, which has some.
Location wholeLogic(Rung& rung);
// Whether a branch may go out there: what is in the list comes straight from the rail.
bool isTrunk(Rung& rung, const std::vector<Node>* list);

std::vector<Node>::iterator iterator(std::vector<Node>& list, std::size_t at);
// Takes the nodes out, as one.
Node takeOut(const Location& at);
// A series comes element by element, one in brackets as a whole.
void insertBehind(const Location& at, Node node);

}  // namespace merker::graph
