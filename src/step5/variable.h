// Values that the command line, scenarios and programmers name: E 0.0, MW 10, T 5, DB10.DW5.
#pragma once

#include <optional>
#include <string_view>

#include "mc5/variable.h"

namespace merker::step5 {

// A constant: KH 7F0A, KF +5, KM …, KT 010.2. Nothing if the text is none.
std::optional<mc5::Operand> parseConstant(std::string_view text);

// Nothing if the text is no operand with a value. Limits of the PLC are not looked at.
std::optional<mc5::Variable> parseVariable(std::string_view text);

}  // namespace merker::step5
