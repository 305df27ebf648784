// The signal of an expression while it is read: what U, O, X and the bare O make of it, as trees.
#pragma once

#include <optional>

#include "graph/network.h"

namespace merker::graph {

class Signal {
 public:
  bool empty() const { return !whole_ && terms_.children.empty() && !current_; }
  // False: the join makes no sense here.
  bool join(Node node);
  // The bare O: what follows is an AND term.
  bool beginTerm();
  // What acts on the whole signal: NOT, an edge, a connector.
  bool append(Node node);
  // So many trees stand within each other by what acted on the whole signal.
  int nesting() const { return nesting_; }
  // The signal as one node; the bare O must have been followed by something.
  std::optional<Node> take();

 private:
  void beginCollecting(NodeKind kind);
  void add(Node node);
  void closeTerm();
  void closeTerms();

  std::optional<Node> whole_;    // where no terms are collected
  Node terms_;                   // OR or XOR: what it has so far
  std::optional<Node> current_;  // the AND term behind a bare O
  bool collecting_ = false, termOpen_ = false;
  // NOT leaves the OR bit as it is: a U behind it would still be joined to the first AND term.
  bool notBehindTerm_ = false;
  int nesting_ = 0;
};

}  // namespace merker::graph
