// The value of an operand for a page.
#pragma once

#include <optional>
#include <string>

#include "address/reference.h"
#include "s7comm/range.h"

namespace merker::itcp {

// Where its bytes are. Nothing: not among those that are copied for readers outside.
std::optional<s7comm::Range> rangeOf(const address::Reference& reference);
// As a person reads it: BOOL as 0 or 1, numbers in decimal, times and dates in their notation,
// characters as they are.
std::string textOf(const address::Reference& reference, const s7comm::Bytes& octets);

}  // namespace merker::itcp
