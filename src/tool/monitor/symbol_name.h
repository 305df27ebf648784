// The symbol of an operand.
#pragma once

#include "address/reference.h"
#include "mc7/operand.h"
#include "source/symbol_table.h"

namespace merker::monitor {

// Null if it has none; data in blocks never has one. `output`: of the periphery, PA.
const source::Symbol* findSymbol(const address::Operand& operand, bool output,
                                 const source::SymbolTable& symbols);
// As it stands in machine code: blocks, too.
const source::Symbol* findSymbol(const mc7::Operand& operand, bool output,
                                 const source::SymbolTable& symbols);

}  // namespace merker::monitor
