// The machine code of a block beside its source, as a listing of rows.
#pragma once

#include <string>
#include <vector>

#include "address/area.h"
#include "monitor/code.h"

namespace merker::monitor {

struct MachineCodeRow {
  std::uint32_t offset = 0;  // in the unit of the block; of a data block of its values
  std::string code;          // words, high byte first: "7E03 0004"
  std::string text;          // the instruction, a parameter of a call; the variable of a data block
  std::uint32_t line = 0;    // of the source; 0: there is none
  // Of a data block: what it begins with and what it has; empty where the code says all.
  std::string initial{}, value{};
};

// Instruction by instruction; of a data block variable by variable. The BE that ends a block
// without a statement of its own has no line. STEP 5 knows one kind of mnemonics only.
std::vector<MachineCodeRow> machineCode(const BlockCode& code, Mnemonics mnemonics);

}  // namespace merker::monitor
