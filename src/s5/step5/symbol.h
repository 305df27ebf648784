// Symbols of an assignment list as operands of a listing, and back.
#pragma once

#include <optional>

#include "mc5/operand.h"
#include "source/symbol_table.h"

namespace merker::step5 {

// What the symbol stands for; nothing if it is no operand of STEP 5.
std::optional<mc5::Operand> operandOf(const source::SymbolAddress& address);

// The symbol of an operand, if it has one; null without a table.
const source::Symbol* symbolOf(const mc5::Operand& operand, const source::SymbolTable* symbols);

}  // namespace merker::step5
