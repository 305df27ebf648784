// Operands that take more than one instruction: how long the way to one is, and how it is named.
#pragma once

#include <string>

#include "awl/names.h"
#include "mc7/listing.h"

namespace merker::graph7 {

struct Access {
  std::size_t length = 1;  // instructions, the last one is the operation
  std::string text;        // of the operand; empty: as the last instruction has it
  bool timer = false;      // a TIMER or COUNTER parameter of an FB
};

// The access that begins at `at` and ends before `end`.
Access accessAt(const mc7::Listing& listing, std::size_t at, std::size_t end,
                const awl::Names& names, Mnemonics mnemonics);

}  // namespace merker::graph7
