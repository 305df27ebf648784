#include "block/memory.h"

#include "block/container.h"

namespace merker::block {

std::size_t loadMemory(const Block& block) { return writeContainer(block).size(); }

std::size_t workMemory(const Block& block) {
  if (block.id.kind == BlockKind::UDT || block.attributes.unlinked) return 0;
  return block.code.empty() ? block.actualData.size() : block.code.size();
}

std::size_t workMemory(const Program& program) {
  std::size_t bytes = 0;
  for (const auto& [id, block] : program) bytes += workMemory(block);
  return bytes;
}

}  // namespace merker::block
