// The elements of a ladder. They are drawn in the order in which the signal goes through them.
#pragma once

#include <cstdint>

#include "graph/flow.h"
#include "graph/network.h"
#include "graph/picture.h"
#include "graph/style.h"

namespace merker::graph {

// Where a drawing begins at its left.
enum class Begin : std::uint8_t { Inside, AtRail };

class LadderElements {
 public:
  explicit LadderElements(const Style& style) : style_(style) {}

  Picture node(const Node& node, Begin begin = Begin::Inside);
  Picture coil(const Coil& coil);
  Signals& signals() { return signals_; }  // where the drawing is

 private:
  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 std::size_t statement, const Selection& of, const Flows& behind, int least = 0);
  Picture symbol(ShapeKind kind, const std::string& text, const std::string& above,
                 const Node& node);
  Picture single(const Node& node, Begin begin);
  Picture wire() const;
  Picture negation(const Node& node);
  Picture operandEdge(const Node& node);
  Picture box(const Node& box, Begin begin);
  Picture series(const Node& series, Begin begin);
  Picture parallel(const Node& parallel, const Signals& outer, Begin begin);
  Flows behind(const Node& node) const;

  const Style& style_;
  Signals signals_;
  int parallels_ = 0;  // around what is being drawn, but for those at the rail
};

}  // namespace merker::graph
