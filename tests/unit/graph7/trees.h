// Random logic as trees in the form in which STEP 7 writes it.
#pragma once

#include <rapidcheck.h>

#include "graph/network.h"

namespace merker::graph7::test {

constexpr int kInputs = 6;  // contacts M 0.0 to M 0.5

rc::Gen<graph::Network> networks();
// Logic within logic as it comes, without brackets and joins.
rc::Gen<graph::Network> unmarkedNetworks();
// The signal of the first rung; bit n of `inputs` is M 0.n.
bool evaluate(const graph::Network& network, unsigned inputs);
graph::Operand flag(unsigned byte, unsigned bit);

}  // namespace merker::graph7::test
