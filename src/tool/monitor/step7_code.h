// What a block of STEP 7 says of its code where it differs from one of STEP 5.
#pragma once

#include <cstdint>
#include <span>

#include "block/block.h"

namespace merker::monitor {

BlockId blockId(const block::Block& block);
std::uint32_t codeLength(const block::Block& block);     // bytes
std::size_t unnamedNetworks(const block::Block& block);  // in front of those with a line
std::uint32_t instructionStart(const block::Block& block, std::uint32_t byte);
std::uint32_t processedInstruction(const block::Block& block, std::uint32_t byte);
std::span<const BlockKind> blockKinds(const block::Program& program);
const block::Block* findBlock(const block::Program& program, BlockId id);  // null: there is none

}  // namespace merker::monitor
