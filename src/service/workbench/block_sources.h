// Where each block stands in the sources, from its keyword to its END_.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "address/block_id.h"
#include "source/source_file.h"
#include "source/symbol_table.h"

namespace merker::workbench {

struct BlockSource {
  std::string file;
  std::uint32_t line = 0;
  std::string text;
};

std::map<BlockId, BlockSource> blockSources(const std::vector<source::SourceFile>& sources,
                                            const source::SymbolTable& symbols);
// The same of STEP 5 listings: from the head to the next one.
std::map<BlockId, BlockSource> listingSources(const std::vector<source::SourceFile>& listings);

}  // namespace merker::workbench
