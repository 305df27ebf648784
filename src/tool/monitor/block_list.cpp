#include "monitor/block_list.h"

#include <fmt/format.h>

#include "block/container.h"
#include "mc5/block_id.h"

namespace merker::monitor {
BlockRow blockRow(const block::Block& block) {
  const auto& attributes = block.attributes;
  return {block.id,
          block.symbol.empty() ? attributes.name : block.symbol,
          block::writeContainer(block).size(),
          block.code.empty() ? block.actualData.size() : block.code.size(),
          block.localBytes,
          fmt::format("{}.{}", attributes.version >> 4, attributes.version & 0xF),
          block::checksum(block),
          0};
}

BlockRow blockRow(const mc5::Block& block) {
  BlockRow row;
  row.id = mc5::neutralId(block.id);
  row.symbol = block.name;
  row.load = block.words.size() + mc5::kHeaderWords;
  row.work = block.words.size();
  row.library = block.library;
  return row;
}

std::vector<BlockRow> blockList(const ProgramCode& program) {
  return program.visit([](const auto& blocks) {
    std::vector<BlockRow> list;
    for (const auto& [id, block] : blocks) list.push_back(blockRow(block));
    return list;
  });
}

}  // namespace merker::monitor
