// The words behind a call of a function block: a jump over the parameters, which the programmer
// inserts and does not show, then the parameters, which are no instructions (4.3.2, S5-FB-06).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mc5/instruction.h"

namespace merker::mc5 {

// SPA FB, SPB FB.
bool callsFunctionBlock(const Instruction& instruction);

// The word behind the list whose jump stands at `jump`; nothing if none stands there or the code
// ends before its target.
std::optional<std::uint32_t> endOfList(std::span<const std::uint16_t> code, std::uint32_t jump);

}  // namespace merker::mc5
