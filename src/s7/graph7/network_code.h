// The networks of a block as statements, and statements as machine code.
#pragma once

#include <optional>
#include <vector>

#include "awl/statements.h"
#include "block/block.h"
#include "graph/statement.h"

namespace merker::graph7 {

struct NetworkCode {
  std::uint32_t begin = 0, end = 0;  // bytes, without the BE at the end of the block
  std::string label;                 // where another network jumps to this one
  graph::Statements statements;
  std::vector<std::string> labels;  // of each statement, where jumps lead inside the network
};

// `names`: of the block with the names of its variables.
std::vector<NetworkCode> networks(const block::Block& block, const awl::Names& names,
                                  const awl::Blocks& blocks, Mnemonics mnemonics);

// Nothing if an operand has no machine code.
std::optional<std::vector<std::uint8_t>> encode(const graph::Statements& statements);

}  // namespace merker::graph7
