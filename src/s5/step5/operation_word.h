// The word of an operation at the beginning of a statement: U, NOP 0, !=F, > = F.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "step5/operand.h"

namespace merker::step5 {

// Reads it in capital letters, signs without their blanks; empty if none begins here. A spelling
// that is taken though it is not the right one gives a warning.
std::string operationWord(Scanner& scanner, std::optional<Failure>& warning);

bool isOperation(std::string_view word);

}  // namespace merker::step5
