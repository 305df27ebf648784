// The blocks of a program as the project manager lists them.
#pragma once

#include <string>
#include <vector>

#include "block/block.h"

namespace merker::monitor {

struct BlockRow {
  BlockId id{};
  std::string symbol;              // symbolic name, or the NAME of its header
  std::size_t load = 0, work = 0;  // bytes: container; code, or actual values of a data block
  std::uint32_t local = 0;
  std::string version;
  std::uint16_t checksum = 0;
};

BlockRow blockRow(const block::Block& block);
std::vector<BlockRow> blockList(const block::Program& program);

}  // namespace merker::monitor
