// An assignment list that comes with a program: what can be used of it, and why the rest cannot.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"
#include "source/symbol_table.h"

namespace merker::s5project {

struct Symbols {
  source::SymbolTable table{source::Language::Step5};
  std::string text;  // of a .sym file; empty without symbols
  std::vector<std::string> notes;
};

// `bytes`: Z0.SEQ, with tabs or fixed columns. Every symbol of `text` is valid in a project.
Symbols readAssignments(const std::string& bytes, Encoding codePage);

}  // namespace merker::s5project
