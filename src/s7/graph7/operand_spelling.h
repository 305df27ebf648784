// Operands that a user types, as texts have them.
#pragma once

#include <string>
#include <string_view>

#include "graph7/source_operand.h"

namespace merker::graph7 {

// "e0.0" is "E 0.0", "FB1,DB1" is "FB 1, DB 1"; names get their # or quotation marks. Of a local
// variable and a symbol the local one is meant. What is known to nobody stays.
std::string spelled(std::string_view typed, const SourceOperands& operands);

}  // namespace merker::graph7
