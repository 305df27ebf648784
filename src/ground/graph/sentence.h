// A network in words, as a screen reader says it: "A 4.0 = E 0.0 and not E 0.1, or M 1.0".
#pragma once

#include <string>
#include <vector>

#include "graph/language.h"
#include "graph/network.h"

namespace merker::graph {

// One sentence for each coil and each box that ends a rung. `names`: of elements and pins.
std::vector<std::string> sentences(const Network& network, Language language, Language names);

}  // namespace merker::graph
