// The program structure of a programming device: what each block calls and which data blocks it
// uses (S7-EDIT-22), from the cross reference. The rows are the same for both families.
#pragma once

#include "monitor/cross_reference.h"

namespace merker::monitor {

struct UsedBlock {
  BlockId id{};
  std::int32_t instance = -1;  // data block that the CALL of a function block names
  bool called = false;         // by a CALL, with parameters; else by UC or CC
};

struct BlockStructure {
  BlockId id{};
  // Local data of its own in bytes, as the CPU allots them (S7-PAR-12); STEP 5 has none.
  std::optional<std::uint32_t> local{};
  std::vector<UsedBlock> uses{};  // each once, ascending
};

// Blocks with code only. `references`: of this program.
std::vector<BlockStructure> programStructure(const ProgramCode& program,
                                             const std::vector<CrossReference>& references);

}  // namespace merker::monitor
