// Actual operands in the parameter list of a call (S5-FB-13, S5-FB-16).
#pragma once

#include <vector>

#include "mc5/block.h"
#include "mc5/range.h"
#include "step5/operand.h"

namespace merker::step5 {

// Appends the word (KG: two words) that stands for the operand. False if it does not fit the
// parameter.
bool appendActual(const mc5::Parameter& parameter, const Operand& actual,
                  std::vector<std::uint16_t>& words);
// Whether the operand is of a kind that the parameter takes and only its number is too large.
bool outOfRange(const mc5::Parameter& parameter, const Operand& actual, mc5::Range& range);
// "EW, AW, MW, DW, PW", for problems.
std::string_view possibleOperands(const mc5::Parameter& parameter);

}  // namespace merker::step5
