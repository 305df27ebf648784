// The elements of a ladder. They are drawn in the order in which the signal goes through them.
#pragma once

#include "graph/flow.h"
#include "graph/network.h"
#include "graph/picture.h"
#include "graph/style.h"

namespace merker::graph {

class LadderElements {
 public:
  explicit LadderElements(const Style& style) : style_(style) {}

  Picture node(const Node& node);
  Picture coil(const Coil& coil);
  Signals& signals() { return signals_; }  // where the drawing is

 private:
  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 std::size_t statement, const Selection& of, const Flows& behind);
  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 const Node& node);
  Picture single(const Node& node);
  Picture wire() const;
  Picture negation(const Node& node);
  Picture operandEdge(const Node& node);
  Picture box(const Node& box);
  Picture series(const Node& series);
  Picture parallel(const Node& parallel, const Signals& outer);
  Flows behind(const Node& node) const;

  const Style& style_;
  Signals signals_;
  int parallels_ = 0;  // around what is being drawn
};

}  // namespace merker::graph
