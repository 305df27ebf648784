// The symbol of an operand.
#pragma once

#include <optional>
#include <string_view>

#include "address/reference.h"
#include "source/symbol_table.h"

namespace merker::monitor {

// As a symbol table names it; nothing for what has no address.
std::optional<source::SymbolAddress> symbolAddress(const address::Operand& operand, bool output);
// Null if it has none; data of STEP 7 never has one, of STEP 5 (DW 5) it is the same in each block.
// `output`: of the periphery, PA.
const source::Symbol* findSymbol(const address::Operand& operand, bool output,
                                 const source::SymbolTable& symbols);
// The symbol that a text names as its language does: "NAME", of STEP 5 -NAME; null: there is none.
const source::Symbol* writtenSymbol(std::string_view text, const source::SymbolTable& symbols);
const source::Symbol* findSymbol(BlockId block, const source::SymbolTable& symbols);

}  // namespace merker::monitor
