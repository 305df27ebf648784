// What stands where the user has not yet written an operand.
#pragma once

#include "graph/statement.h"

namespace merker::graph {

// As STEP 7 shows it; a connector differs, so that `= ??.?` and the `U ??.?` of the next rung are
// not one.
constexpr std::string_view kMissingBit = "??.?", kMissingValue = "???", kMissingConnector = "??.#";

// Operands whose text begins so are missing, whatever the operation. They are numbers, which can
// stand everywhere, with their text as `code`.
constexpr std::string_view kMissingBegin = "??";

Operand missing(std::string_view text);
bool isMissing(const Operand& operand);

}  // namespace merker::graph
