#include "monitor/block_list.h"

#include <fmt/format.h>

#include "block/container.h"

namespace merker::monitor {

BlockRow blockRow(const block::Block& block) {
  const auto& attributes = block.attributes;
  return {block.id,
          block.symbol.empty() ? attributes.name : block.symbol,
          block::writeContainer(block).size(),
          block.code.empty() ? block.actualData.size() : block.code.size(),
          block.localBytes,
          fmt::format("{}.{}", attributes.version >> 4, attributes.version & 0xF),
          block::checksum(block)};
}

std::vector<BlockRow> blockList(const block::Program& program) {
  std::vector<BlockRow> list;
  for (const auto& [id, block] : program) list.push_back(blockRow(block));
  return list;
}

}  // namespace merker::monitor
