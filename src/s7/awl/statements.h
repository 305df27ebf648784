// Machine code as the statements that an editor shows: one line each, a CALL with its parameters.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "awl/names.h"
#include "block/block.h"

namespace merker::awl {

struct Statement {
  std::uint32_t offset = 0;        // bytes, of its first instruction
  std::string label;               // "M001", empty
  std::vector<std::string> lines;  // "U     E 0.0", without the semicolon
  // As the editor counts: those of the CALL where it is written as instructions, at its first one.
  std::size_t editorLines = 0;
};

// The blocks that CALL can name, with the names of their interfaces; null for none.
using Blocks = std::function<const block::Block*(BlockId id)>;

// Of the whole code without the BE that every compiler adds at its end. `calls`: brackets of CALL
// become CALL where they have a form that is known.
std::vector<Statement> statements(const block::Block& block, const Names& names,
                                  const Blocks& blocks, bool calls);

}  // namespace merker::awl
