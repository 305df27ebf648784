// Values that the command line, scenarios and programmers name: E 0.0, MW 10, T 5, DB10.DW5.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "address/reference.h"
#include "base/problem.h"
#include "mc5/operand.h"
#include "source/symbol_table.h"

namespace merker::step5 {

// A constant: KH 7F0A, KF +5, KM …, KT 010.2. Nothing if the text is none.
std::optional<mc5::Operand> parseConstant(std::string_view text);

// E 0.0, MW 10, T 5, DB10.DW 5 …: nothing if the text is not an operand with a value. Limits of the
// PLC are not checked.
// Symbols: -MOTOR, "DATEN".DW 5.
std::optional<address::Reference> parseVariable(std::string_view text,
                                                const source::SymbolTable* symbols = nullptr);

// P1112: a number or bit that this PLC does not have (E 0.8, MB 256, T 99). Nothing for others; how
// many words a data block has is not known here.
std::optional<Problem> checkRange(std::string_view text, const source::SymbolTable* symbols,
                                  const Position& at);

// MOTOR of -MOTOR and "MOTOR"; empty if the text names no symbol.
std::string symbolName(std::string_view text);

}  // namespace merker::step5
