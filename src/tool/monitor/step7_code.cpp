#include "monitor/step7_code.h"

#include "mc7/disassembly.h"

namespace merker::monitor {

BlockId blockId(const block::Block& block) { return block.id; }

std::uint32_t codeLength(const block::Block& block) {
  return static_cast<std::uint32_t>(block.code.size());
}

std::size_t unnamedNetworks(const block::Block&) { return 0; }

std::uint32_t instructionStart(const block::Block& block, std::uint32_t byte) {
  std::uint32_t at = 0;
  for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German))
    if (line.kind == mc7::LineKind::Instruction && line.offset <= byte) at = line.offset;
  return at;
}

std::uint32_t processedInstruction(const block::Block&, std::uint32_t byte) { return byte; }

std::span<const BlockKind> blockKinds(const block::Program&) {
  static constexpr BlockKind kKinds[] = {BlockKind::OB, BlockKind::FC, BlockKind::FB,
                                         BlockKind::DB};
  return kKinds;
}

const block::Block* findBlock(const block::Program& program, BlockId id) {
  const auto found = program.find(id);
  return found == program.end() ? nullptr : &found->second;
}

}  // namespace merker::monitor
