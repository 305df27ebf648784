// The lines of a block as STEP 5 numbers them for its comments: statements in each network from 1,
// the parameter lines of a call of a function block among them; data words from 0.
#pragma once

#include <cstdint>
#include <vector>

#include "mc5/block.h"

namespace merker::s5d {

// What a line of the comment block belongs to.
struct CommentLine {
  std::uint32_t offset = 0;   // words
  std::uint32_t network = 0;  // from 1; of data 0
  std::uint32_t line = 0;
};

// In the order of the code. The line NAME of a call has the offset of its first parameter.
std::vector<CommentLine> commentLines(const mc5::Program& program, const mc5::Block& block);
// Words where networks begin, the first among them.
std::vector<std::uint32_t> networkStarts(const mc5::Program& program, const mc5::Block& block);

}  // namespace merker::s5d
