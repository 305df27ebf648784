// The frame of a box node; how logic at its pins is drawn is for KOP or FUP to say.
#pragma once

#include <functional>

#include "graph/frame.h"
#include "graph/network.h"
#include "graph/style.h"

namespace merker::graph {

// Draws the logic of a pin; sets `negated` where the box draws the negation itself.
using DrawPin = std::function<FramePin(const Node& logic)>;

FrameText boxFrame(const Node& box, const Style& style, const DrawPin& draw);

}  // namespace merker::graph
