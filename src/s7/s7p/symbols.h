// The symbol list of a program: SYMLIST.DBF.
#pragma once

#include <string>
#include <vector>

#include "archive/tree.h"
#include "base/code_page.h"
#include "s7p/fault.h"

namespace merker::s7p {

struct SymbolRow {
  std::string name;
  std::string address;  // "E 1.0", "FC 500"; German
  std::string type;     // "BOOL", "FB 10"
  std::string comment;
};

// Rows without an operand are unfinished and left out.
std::vector<SymbolRow> readSymbols(const archive::Tree& tree, const std::string& folder,
                                   const CodePage& page, Faults& faults);

}  // namespace merker::s7p
