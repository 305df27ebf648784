// A network as it is written in a source text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph/statement.h"

namespace merker::graph {

// Where a statement is written. A line may hold several statements, a statement several lines.
struct Written {
  std::uint32_t line = 1, end = 2;      // lines [line, end), a label in front of it included
  std::size_t start = 0, begin = 0;     // bytes of the file: of the label, of the statement
  std::size_t operand = 0, length = 0;  // where its operand begins; how long it is, with its `;`
  std::string label;                    // in front of it
  std::string text;                     // "U     E 0.0", without label, `;` and comment
};

// Lines count from 1. Statements that no picture shows are there, too, as OTHER.
struct SourceNetwork {
  std::string title, label;          // label: at its beginning, where jumps lead to
  std::uint32_t labelLine = 0;       // of a label that waits for the first statement; 0: none
  std::vector<std::string> comment;  // lines behind the title, without //
  std::uint32_t line = 1;            // of its head, or of its first statement if it has no head
  std::uint32_t code = 1;            // the first line behind head, title and comment
  std::uint32_t end = 1;             // behind its last line; a BE that ends the block is not in it
  bool headed = true;                // a line begins it: NETWORK, NETZWERK 2, …
  Statements statements;
  std::vector<Written> places;  // one for each statement
};

}  // namespace merker::graph
