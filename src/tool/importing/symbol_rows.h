// Symbol rows of a project as a table of Merker.
#pragma once

#include "importing/material.h"
#include "importing/report.h"
#include "source/symbol_table.h"

namespace merker::importing {

// Rows that no symbol table may have are left out with a note.
source::SymbolTable tableOf(const std::vector<s7p::SymbolRow>& rows, Report& report);

}  // namespace merker::importing
