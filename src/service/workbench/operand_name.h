// How an operand is called: its address, and its symbol if it has one.
#pragma once

#include <string>

#include "address/reference.h"
#include "source/symbol_table.h"

namespace merker::workbench {

struct OperandName {
  std::string operand;  // "E 0.0", "DB1.DBW 4"
  std::string symbol;   // "Motor", or the symbolic text itself: "Data".count
  std::string comment;
  std::string type;  // "INT"; empty for an absolute operand
  unsigned bits = 0;
};

OperandName operandName(const address::Reference& reference, const source::SymbolTable& symbols);

}  // namespace merker::workbench
