// The fields of a bit pattern, one letter each: how a number in the code becomes part of an operand
// and back.
#pragma once

#include <cstdint>
#include <optional>

#include "mc5/operand.h"

namespace merker::mc5 {

// Puts the number into the operand. False if the field does not allow it.
bool decodeField(char letter, std::uint32_t number, Operand& operand);
std::optional<std::uint32_t> encodeField(char letter, const Operand& operand);

// The format byte of a two-word constant (OP-46).
std::optional<Format> formatOf(std::uint8_t code);

}  // namespace merker::mc5
