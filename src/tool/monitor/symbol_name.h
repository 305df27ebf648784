// The symbol of an operand.
#pragma once

#include "address/reference.h"
#include "source/symbol_table.h"

namespace merker::monitor {

// Null if it has none; data in blocks never has one. `output`: of the periphery, PA.
const source::Symbol* findSymbol(const address::Operand& operand, bool output,
                                 const source::SymbolTable& symbols);
const source::Symbol* findSymbol(BlockId block, const source::SymbolTable& symbols);

}  // namespace merker::monitor
