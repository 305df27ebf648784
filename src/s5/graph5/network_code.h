// The networks of a block of STEP 5 as statements, and statements as machine code.
#pragma once

#include <optional>
#include <vector>

#include "graph/statement.h"
#include "mc5/block.h"

namespace merker::graph5 {

struct NetworkCode {
  std::uint32_t begin = 0, end = 0;  // words, without the BLD 255 or BE behind it
  graph::Statements statements;      // offsets count words
};

std::vector<NetworkCode> networks(const mc5::Block& block);

// Nothing if an operand has no machine code.
std::optional<std::vector<std::uint16_t>> encode(const graph::Statements& statements);

}  // namespace merker::graph5
