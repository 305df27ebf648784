// Operands of STEP 5 as places that both families name.
#pragma once

#include "address/reference.h"
#include "mc5/operand.h"

namespace merker::mc5 {

// E, A, M, P, D, T, Z; kind None for what has no fixed place or no such bit (E 0.8).
// Of data the block is not known here.
address::Operand placeOf(const Operand& operand);

}  // namespace merker::mc5
