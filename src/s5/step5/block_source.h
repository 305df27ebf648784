// Where the blocks of a listing stand: heads (OB 1, FB 140 SPRM-A BIB=14050) and the lines that
// belong to them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mc5/block_id.h"
#include "source/source_file.h"

namespace merker::step5 {

struct Line {
  std::string_view text;   // without its end of line
  std::size_t offset = 0;  // in the file
};

struct BlockSource {
  const source::SourceFile* file = nullptr;
  mc5::BlockId id;
  std::size_t offset = 0, length = 0;  // of "FB 140" in the file
  std::string name;                    // behind the number of an FB
  std::uint32_t library = 0;
  std::vector<std::string> heading;  // comments of the file above its first block
  std::string comment;               // behind the head
  std::vector<Line> lines;
};

std::vector<BlockSource> findBlocks(const source::SourceFile& file, Problems& problems);

using mc5::toString;  // "FB 140"

}  // namespace merker::step5
