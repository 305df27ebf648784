// The terms of a //= comment: what holds after an instruction (command line contract, self-checking
// programs).
#pragma once

#include <optional>

#include "check/check.h"
#include "step7/local_data.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

// `localData`: for the way to a parameter that is not addressed where it arrives.
std::optional<block::Check> parseCheckComment(const CheckComment& comment, const Scope& scope,
                                              LocalData& localData, Problems& problems);

}  // namespace merker::step7
