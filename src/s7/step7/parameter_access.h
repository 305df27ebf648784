// Formal parameters that cannot be addressed where they arrive: composite ones, whose POINTER is
// followed, and numbers of timers, counters and blocks that an instance holds (code patterns,
// section 4). Nothing is kept from one access to the next.
#pragma once

#include <vector>

#include "step7/operand_parser.h"

namespace merker::step7 {

// How the POINTER of a parameter is followed.
struct PointerPath {
  const block::Variable& parameter;
  std::uint32_t word;         // of local data, for the number of the data block
  Area own = Area::Instance;  // through which register an FB reaches its instance
  bool opens = true;          // false: only the word and AR1 are set
  bool asInstance = false;    // the data block is opened as DI
};

// L P##p, LAR1, … (FC) or L DIW [AR2,P#p], … (FB): the number in the word, the block open, the
// address in AR1. Uses AKKU 1 and 2.
std::vector<mc7::Instruction> followPointer(const Scope& scope, const PointerPath& path);

// AUF DB [LW n], AUF DI [LW n]
mc7::Operand blockInWord(std::uint32_t word, bool asInstance);

// The number of a parameter of an FB in a word of local data: its loading, and the operand.
struct NumberPath {
  std::vector<mc7::Instruction> code;
  mc7::Operand operand;
};
NumberPath followNumber(const Access& access, std::uint32_t word);

}  // namespace merker::step7
