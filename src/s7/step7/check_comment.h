// The terms of a //= comment: what holds after an instruction (command line contract, self-checking
// programs).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "check/check.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

using ParameterCopies = std::vector<std::pair<const block::Variable*, std::uint32_t>>;

// `usedCopies` gets the parameters whose copies in local data the terms read.
std::optional<block::Check> parseCheckComment(const CheckComment& comment, const Scope& scope,
                                              const ParameterCopies& copies,
                                              std::vector<const block::Variable*>& usedCopies,
                                              Problems& problems);

}  // namespace merker::step7
