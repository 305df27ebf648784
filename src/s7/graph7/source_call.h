// A CALL with its parameter list, as a source text has it.
#pragma once

#include "graph/statement.h"
#include "graph7/source_operand.h"

namespace merker::graph7 {

// Behind the word CALL; the cursor then stands behind the list. If it is to be complete, parameters
// that are not supplied are there, too, without a text, if the called block is known.
void readCall(step7::Cursor& cursor, const SourceOperands& operands, bool complete,
              graph::Statement& statement);

// The parameters that the block named by the text has, none supplied; nothing if it is not known.
std::vector<graph::Argument> parametersOf(std::string_view text, const SourceOperands& operands);

}  // namespace merker::graph7
