// Comparisons of scenarios: the rules of self-checking programs (raw bits as unsigned numbers, the
// narrower side filled up with zeros, ~= as REAL within 1e-6), typed variables ordered as their
// type is, and beside an integer a number with sign.
#pragma once

#include <string>

#include "check/check.h"
#include "scenario/term.h"

namespace merker::simulator {

// False also if an operand does not exist.
bool holds(const Term& left, block::Relation relation, const Term& right, const Reader& read);

// For a message: the left side's value, written like the right side, and the right side's if it is
// an operand.
std::string actualValue(const Term& left, const Term& right, const Reader& read);

// The value that `term` has now; nothing if the operand does not exist. `other` is what it is
// compared with: a timer gives its status bit beside 0, 1 and TRUE, its coded value beside S5T#,
// else its number (L T 1).
std::optional<std::uint32_t> value(const Term& term, const Term& other, const Reader& read);

}  // namespace merker::simulator
