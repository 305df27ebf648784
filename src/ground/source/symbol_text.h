// What readers and writers of symbol files share, and editors of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "source/symbol_table.h"

namespace merker::source {

// The four items of a symbol (S7-SYM-01) as they stand in a file, without blanks around them. Views
// into the file, so that a problem can name its place.
struct SymbolLine {
  const SourceFile* file = nullptr;
  std::string_view line;
  std::string_view name, address, type, comment;

  // The place of one item; of the line if there is no such item.
  Position at(std::string_view item) const {
    const std::string_view where = item.empty() ? line : item;
    return file->position(static_cast<std::size_t>(where.data() - file->text().data()),
                          where.size());
  }
};

// Columns of STEP 7's exports, in characters (S7-SYM-01).
constexpr std::size_t kNameWidth = 24;
constexpr std::size_t kAddressWidth = 12;
constexpr std::size_t kTypeWidth = 10;
constexpr std::size_t kCommentWidth = 80;

// "MW" and "10"; "E" and "1.0".
std::string_view operandName(const SymbolAddress& address, Mnemonics mnemonics,
                             Language language = Language::Step7);
std::string operandNumber(const SymbolAddress& address);

// What stands in the type column: "INT", "TIMER", "FB 3", "VAT 1".
std::string typeText(const Symbol& symbol);

// Checks the items and adds the symbol to the table. `comment` is line.comment without quotation
// marks that the format doubles.
void addSymbol(const SymbolLine& line, std::string comment, SymbolTable& table, Problems& problems);

// As writeSymbols, but UTF-8 whatever the format.
std::string symbolText(const SymbolTable& table, std::string_view extension, Mnemonics mnemonics);

// ".sdf" of "plant/Symbols.SDF", lower case; empty if there is none.
std::string extensionOf(std::string_view path);

}  // namespace merker::source
