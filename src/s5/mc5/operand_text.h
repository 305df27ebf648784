// Operands as listings write them.
#pragma once

#include <string>

#include "mc5/operand.h"

namespace merker::mc5 {

// "E 0.0", "DW 5", "KF +7", "=+4"; empty if there is no operand.
std::string operandText(const Operand& operand);

}  // namespace merker::mc5
