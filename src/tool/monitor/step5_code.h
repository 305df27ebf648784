// A block of STEP 5: its machine code, instruction by instruction, and what it says of its code
// where it differs from one of STEP 7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "address/block_id.h"
#include "mc5/block.h"
#include "mc5/instruction.h"

namespace merker::monitor {

struct Step5Instruction {
  std::uint32_t offset = 0, next = 0;  // words; behind it and the list that belongs to it
  mc5::Instruction instruction;
  std::span<const std::uint16_t> list;  // words of the parameters behind a call (S5-FB-06)
};

// In the order of the code, without words that are none.
std::vector<Step5Instruction> step5Instructions(const mc5::Block& block);
// The FB of the program or the macro that the call enters; null: there is none.
const mc5::Block* calledFunctionBlock(const mc5::Program& program, const mc5::Instruction& call);

BlockId blockId(const mc5::Block& block);
std::uint32_t codeLength(const mc5::Block& block);     // words
std::size_t unnamedNetworks(const mc5::Block& block);  // in front of those with a line
std::uint32_t instructionStart(const mc5::Block& block, std::uint32_t word);
std::uint32_t processedInstruction(const mc5::Block& block, std::uint32_t word);
std::span<const BlockKind> blockKinds(const mc5::Program& program);
const mc5::Block* findBlock(const mc5::Program& program, BlockId id);  // null: there is none

}  // namespace merker::monitor
