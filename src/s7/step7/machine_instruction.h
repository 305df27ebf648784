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

// An entry of the list behind a call, as the disassembler prints it: P#V 20.0, 5 (timer, counter,
// block), DW#16#…. Nothing if the text does not begin as one.
std::optional<Result<std::uint32_t>> parseMachineEntry(std::string_view text, const Position& at);

}  // namespace merker::step7
