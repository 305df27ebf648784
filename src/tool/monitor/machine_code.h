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
  std::string text;          // the instruction, a parameter of a call; empty: data
  std::uint32_t line = 0;    // of the source; 0: there is none
};

// Instruction by instruction; of a data block its actual values. STEP 5 knows one kind of mnemonics
// only.
std::vector<MachineCodeRow> machineCode(const BlockCode& code, Mnemonics mnemonics);

}  // namespace merker::monitor
