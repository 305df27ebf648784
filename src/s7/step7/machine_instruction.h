// One instruction on its own, as `merker assemble --mc7` takes it: what the disassembler prints,
// with jump distances in words and parameters of an FC by their index (#P0).
#pragma once

#include <optional>
#include <string_view>

#include "base/result.h"
#include "mc7/instruction.h"

namespace merker::step7 {

Result<mc7::Instruction> parseMachineInstruction(std::string_view text, const Position& at,
                                                 std::optional<Mnemonics> setting);

}  // namespace merker::step7
