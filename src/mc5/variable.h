// An operand as somebody outside a program names it: of data with the number of its block.
#pragma once

#include "mc5/operand.h"

namespace merker::mc5 {

struct Variable {
  Operand operand;
  std::uint16_t dataBlock = 0;  // DB10.DW5: 10
};

}  // namespace merker::mc5
