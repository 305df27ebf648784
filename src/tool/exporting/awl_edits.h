// What changes in a source on its way to STEP 7, which is stricter than Merker.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "source/symbol_table.h"
#include "step7/block_source.h"

namespace merker::exporting {

// Text in place of a part of the source; an insertion has no length.
struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

// The part of the source with its edits, which do not overlap.
std::string edited(std::string_view text, std::size_t begin, std::size_t end,
                   std::vector<Edit> edits);

// A semicolon behind each statement, brackets and commas for parameter lists without them.
std::vector<Edit> punctuation(const step7::BlockSource& block);

// E 1.0 in place of "START". The data block of "Motor".speed keeps its symbol: STEP 7 has no
// absolute form of it.
std::vector<Edit> absoluteOperands(const step7::BlockSource& block,
                                   const source::SymbolTable& symbols, Mnemonics mnemonics);
// "START" in place of E 1.0, in statements.
std::vector<Edit> symbolicOperands(const step7::BlockSource& block,
                                   const source::SymbolTable& symbols);

// For each block what its parameters, in capital letters, are called instead.
using ParameterNames = std::map<BlockId, std::map<std::string, std::string>>;
// The other names in the calls of these blocks.
std::vector<Edit> renamedParameters(const step7::BlockSource& block,
                                    const source::SymbolTable& symbols,
                                    const ParameterNames& names);

}  // namespace merker::exporting
