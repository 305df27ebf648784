// Parts of a ladder that are put together.
#pragma once

#include "graph/picture.h"

namespace merker::graph {

// A box that the signal goes through gets its wire at the left, above its operands.
Picture through(Picture box, const Flows& before);
// The parts of a series: the signal goes through all of them on one row.
Picture beside(const std::vector<Picture>& parts);
// A coil at the right of so many columns.
Picture atEnd(const Picture& coil, int width);

// Where a rung goes on below, ">1", and where it comes from, "1>".
Picture goesOn(int line, const Flows& flow);
Picture comesFrom(int line, const Flows& flow);
constexpr int kMark = 5;  // columns of a mark with two digits and its wire

}  // namespace merker::graph
