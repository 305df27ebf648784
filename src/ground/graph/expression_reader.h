// Reads logic: everything that makes a signal, with the boxes on its way.
#pragma once

#include "graph/cursor.h"
#include "graph/read.h"
#include "graph/signal.h"

namespace merker::graph {

class ExpressionReader {
 public:
  ExpressionReader(Cursor& cursor, const Rules& rules) : cursor_(cursor), rules_(rules) {}

  struct Logic {
    std::optional<Node> node;
    bool ended = false;  // by a box whose output is open: nothing can follow
  };
  // Up to the first statement that is no logic. Nothing: refused. `boxes`: with boxes that stand
  // in the signal without brackets of their own, as at the beginning of a rung or bracket.
  std::optional<Logic> read(bool boxes);

 private:
  bool item(Signal& signal);
  bool contact(Signal& signal, const struct BitOperation& row);
  bool bracket(Signal& signal, const struct BitOperation& row);
  bool operandEdge(Signal& signal);
  bool acts(Signal& signal);
  bool connector(Signal& signal);
  bool parameter(Signal& signal);
  bool beginsConnector() const;
  bool beginsParameter() const;
  bool box(Logic& logic, Signal& signal, bool compareOnly);

  Cursor& cursor_;
  const Rules& rules_;
  int depth_ = 0;
  int chained_ = 0;              // boxes in the expression, each behind the one before
  std::vector<Pin> parameters_;  // of the CALL that must follow
};

}  // namespace merker::graph
