// The fields of a bit pattern, one letter each: how a number in the code becomes part of an operand
// and back.
#pragma once

#include <cstdint>
#include <optional>

#include "mc7/operand.h"

namespace merker::mc7 {

// Puts the number into the operand. False if the field does not allow it (an area that does not
// exist …).
bool decodeField(char letter, std::uint32_t number, Operand& operand);
// The number that stands for this part of the operand; nothing if there is none.
std::optional<std::uint32_t> encodeField(char letter, const Operand& operand);

}  // namespace merker::mc7
