// The symbol of an operand as it stands in machine code.
#pragma once

#include "mc7/operand.h"
#include "source/symbol_table.h"

namespace merker::monitor {

// Null if it has none; data in blocks never has one. `output`: of the periphery, PA.
const source::Symbol* findSymbol(const mc7::Operand& operand, bool output,
                                 const source::SymbolTable& symbols);

}  // namespace merker::monitor
