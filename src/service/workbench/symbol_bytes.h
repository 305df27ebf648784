// A symbol table as the bytes of a file, in a code page that has its characters.
#pragma once

#include <string>
#include <string_view>

#include "source/symbol_table.h"

namespace merker::workbench {

struct SymbolBytes {
  static constexpr unsigned kUtf8 = 65'001;  // the number that Windows gives it

  std::string bytes;
  unsigned page = kUtf8;
  std::size_t missing = 0;  // characters that are '?' in the file
};

// For the original tools: the page of Windows that has most characters (CP437 for STEP 5); .sym is
// UTF-8.
SymbolBytes symbolBytes(const source::SymbolTable& table, std::string_view extension);
// For the project: the same, and UTF-8 where a page would lose characters or is not CP1252, which
// is read back with certainty.
std::string storedSymbols(const source::SymbolTable& table, std::string_view extension);

}  // namespace merker::workbench
