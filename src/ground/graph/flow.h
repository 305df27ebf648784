// The signal at each place of a drawing, as status bits of its statements: nothing is calculated a
// second time.
#pragma once

#include "graph/network.h"
#include "graph/picture.h"

namespace merker::graph {

// How a node or coil is named from outside.
Selection selectionOf(const Node& node);
Selection selectionOf(const Coil& coil);

// Goes along with whoever draws the nodes in their order. Behind most elements the signal is the
// VKE; in a branch of an OR the VKE belongs to all branches so far, and the signal is the AND of
// the elements of this one.
class Signals {
 public:
  // Where the drawing is.
  const Flows& now() const { return now_; }
  // Logic of its own begins, at the rail or with the first operand of a pin.
  void begin() { *this = {}; }
  // The logic at a pin begins with the signal at which the box stands.
  void beginAt(const Flows& before);

  // The node, without children, has been passed.
  void pass(const Node& node);
  // Around the children of a group; what `enter` gives goes to `leave`.
  Signals enter(const Node& group);
  void branch(const Signals& outer);  // the next branch begins
  void leave(const Node& group, Signals outer);

 private:
  Flows before_;  // what all statements of this bracket do not know of
  Flows now_;
  bool inTerm_ = false;
};

}  // namespace merker::graph
