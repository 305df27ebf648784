// The terms of a //= comment: what holds after an instruction (command line contract,
// self-checking programs).
#pragma once

#include <vector>

#include "check/check.h"
#include "mc5/block.h"
#include "step5/operand.h"

namespace merker::step5 {

struct Checks {
  std::vector<block::CheckTerm> terms;
  std::vector<Failure> failures;
};

// `words`: where each parameter of the block begins in a parameter list.
Checks parseChecks(Scanner& scanner, const mc5::Block& block,
                   const std::vector<std::uint32_t>& words,
                   const source::SymbolTable* symbols = nullptr);

}  // namespace merker::step5
