// Puts changed statements into the lines of a network. Lines whose statements stay are kept as they
// are; a statement that takes the place of another keeps the comment behind it.
#pragma once

#include <functional>
#include <set>

#include "graph/source_network.h"
#include "networks/source_edit.h"

namespace merker::networks {

// How the statements of a text are written.
struct Style {
  std::string indent;         // before the operation
  std::size_t operandAt = 6;  // column of the operand behind that of the operation
  std::string end;            // behind the operand: ";"
};

// A statement without indent and end; the label is that of its target.
using WriteStatement =
    std::function<std::string(const graph::Statement& statement, const std::string& label)>;

struct Splice {
  const source::SourceFile& file;
  const graph::SourceNetwork& network;
  const graph::Statements& now;
  const Style& style;
  const WriteStatement& write;
  std::set<std::string> labels;  // of the whole block
};

TextEdit spliced(Splice splice);

}  // namespace merker::networks
