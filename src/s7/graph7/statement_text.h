// Statements as AWL writes them.
#pragma once

#include <string>

#include "address/area.h"
#include "graph/statement.h"

namespace merker::graph7 {

struct StatementStyle {
  Mnemonics mnemonics = Mnemonics::German;
  std::size_t operandAt = 6;      // column of the operand behind that of the mnemonic
  std::string indent = "      ";  // of the lines of a CALL behind its first one
};

// Without label and semicolon; a CALL with parameters has several lines. `label`: where a jump
// inside the network leads.
std::string statementText(const graph::Statement& statement, const StatementStyle& style,
                          const std::string& label = {});

}  // namespace merker::graph7
