// The blocks of a program as the project manager lists them.
#pragma once

#include <string>
#include <vector>

#include "monitor/code.h"

namespace merker::monitor {

struct BlockRow {
  BlockId id{};
  std::string symbol;  // symbolic name, or the NAME of its header
  // S7: bytes of the container; of the code, or the actual values of a data block. STEP 5: words
  // with and without the header (S5-BLK-08).
  std::size_t load = 0, work = 0;
  // S7
  std::uint32_t local = 0;
  std::string version;
  std::uint16_t checksum = 0;
  // STEP 5
  std::uint32_t library = 0;  // BIB; 0: none
};

BlockRow blockRow(const block::Block& block);
BlockRow blockRow(const mc5::Block& block);
std::vector<BlockRow> blockList(const ProgramCode& program);

}  // namespace merker::monitor
