// Instructions with checks or coverage run through these handlers; all others do not know of them.
#pragma once

#include "interpreter/translated.h"

namespace merker::interpreter {

// In place of the instruction's own handler.
const Op* runWithSide(cpu::Machine& m, const Op* op);
// Stands in the way back from a block that the instruction called, or from an error OB.
const Op* runAfterCall(cpu::Machine& m, const Op* op);

}  // namespace merker::interpreter
