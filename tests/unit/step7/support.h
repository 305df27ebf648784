// Compiles a text and shows what came out of it, for tests of the compiler.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "step7/compiler.h"

namespace merker::step7 {

struct Compiled {
  Compilation result;
  // "5:3 P0214" for each problem, in order.
  std::vector<std::string> problems() const;
  const block::Block& block(BlockKind kind, int number) const;
  // One instruction a line, German mnemonics; entries of parameter lists as P#….
  std::string listing(BlockKind kind, int number) const;
};

Compiled compileText(std::string_view text, std::string_view model = "314C-2 PtP",
                     bool checks = false, const source::SymbolTable* symbols = nullptr);
// The statements as OB 1, its listing without the final BE.
std::string statements(std::string_view code, std::string_view model = "generic");

}  // namespace merker::step7
