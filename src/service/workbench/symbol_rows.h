// The symbol table as rows of an editor: texts as they are typed, checked all at once (S7-SYM-03).
#pragma once

#include <string>
#include <vector>

#include "source/symbol_table.h"
#include "workbench/json.h"

namespace merker::workbench {

struct SymbolRow {
  std::string symbol, operand, type, comment;
};

SymbolRow symbolRow(const source::Symbol& symbol, source::Language language);
Json toJson(const SymbolRow& row);

// A problem of row `row` (from 0) in its field "symbol", "operand", "type" or "comment".
struct RowProblem {
  std::size_t row = 0;
  std::string_view field;
  Problem problem;
};

struct CheckedRows {
  source::SymbolTable table;
  std::vector<RowProblem> problems;
  bool good() const;  // warnings do not count
};

// By the rules of symbol files: each row is read as a line of one.
CheckedRows checkRows(const std::vector<SymbolRow>& rows, source::Language language);
Json toJson(const std::vector<RowProblem>& problems);

}  // namespace merker::workbench
