// One line of text for the code of a block: what the tests of the exact patterns compare.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "support.h"

namespace merker::step7 {

// A row of a table: declarations and statements of the calling block, the whole code it becomes.
struct Golden {
  const char* declarations;
  const char* statements;
  const char* code;  // "BLD 1; = L 0.0; …"
};

// "L W #P0; T LW 2; BE"; checks as well that assembling the listing gives the same bytes.
std::string codeOf(const Compiled& compiled, BlockKind kind, int number);
// FC 9, FB 9 or OB 1 with these declarations and statements, among `others`.
std::string compiledIn(BlockKind kind, const Golden& row, std::string_view others);

void expectCode(BlockKind kind, std::span<const Golden> rows, std::string_view others);

}  // namespace merker::step7
