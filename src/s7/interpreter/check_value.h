// One side of a check: a constant, a register, or an operand that a piece of code looks at.
#pragma once

#include <cstdint>
#include <optional>

#include "check/check.h"
#include "interpreter/translated.h"

namespace merker::interpreter {

// Nothing if the operand cannot be read here. Registers, time and faults stay as they are.
std::optional<std::uint32_t> valueOf(cpu::Machine& m, const block::CheckValue& value,
                                     const Translated& snippet);

}  // namespace merker::interpreter
