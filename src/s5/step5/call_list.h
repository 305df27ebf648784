// The parameter list behind a call of a function block, read back from machine code (S5-FB-06,
// S5-FB-16).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mc5/block.h"
#include "mc5/instruction.h"

namespace merker::step5 {

struct ListedParameter {
  std::uint32_t offset = 0, words = 1;  // in the calling block
  std::string name, actual;             // "ZAHL", "KF +25"
  mc5::Operand operand;                 // of a constant None
};

struct CallList {
  const mc5::Block* called = nullptr;
  std::uint32_t end = 0;  // the word behind the list
  std::vector<ListedParameter> parameters;
};

// A call of an FB is always followed by a jump over its parameters. Nothing if `call` calls no FB
// of the program or among the macros, or if what stands at `next` is not its list.
std::optional<CallList> callList(const mc5::Program& program, const mc5::Block& block,
                                 const mc5::Instruction& call, std::uint32_t next);

}  // namespace merker::step5
