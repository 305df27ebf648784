// What an instruction with a formal operand stands for (S5-FB-15 … -17, S5-SUBST).
#pragma once

#include <optional>
#include <span>

#include "mc5/instruction.h"

namespace merker::sinumerik {

// With this word of the parameter list; nothing if the two do not fit.
std::optional<mc5::Instruction> actualInstruction(const mc5::Instruction& formal,
                                                  std::uint16_t word);
// Its row in the table; null: there is no such instruction.
const mc5::Encoding* rowOf(const mc5::Instruction& instruction);

}  // namespace merker::sinumerik
