// A network as function block diagram.
#pragma once

#include "graph/network.h"
#include "graph/picture.h"
#include "graph/style.h"

namespace merker::graph {

Picture fup(const Network& network, const Style& style);

}  // namespace merker::graph
