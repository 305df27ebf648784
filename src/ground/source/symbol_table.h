// The symbol table of a program (S7-SYM): names for absolute operands and blocks. STEP 5 calls it
// assignment list.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "address/area.h"
#include "address/block_id.h"
#include "address/type_code.h"
#include "base/problem.h"
#include "source/source_file.h"

namespace merker::source {

// Which operands there are and how they are written.
enum class Language : std::uint8_t { Step7, Step5 };

// What a symbol stands for.
struct SymbolAddress {
  enum class Kind : std::uint8_t {
    Memory,
    Timer,
    Counter,
    Block,
    VariableTable
  } kind = Kind::Memory;
  // Memory: Input, Output, Flag, Peripheral; of STEP 5 also DataBlock, the one that is open
  Area area = Area::None;
  Width width = Width::Bit;
  BitAddress address = 0;
  bool peripheralOutput = false;  // Peripheral: PA instead of PE; STEP 5 has one for both
  std::uint16_t number = 0;       // Timer, Counter, VariableTable
  BlockId block;                  // Block
  auto operator<=>(const SymbolAddress&) const = default;
};

struct Symbol {
  std::string name;  // at most 24 characters
  SymbolAddress address;
  TypeCode type = TypeCode::Bool;    // Memory; Timer and Counter for those; Void for blocks
  std::optional<BlockId> blockType;  // DB of type FB 3 / UDT 2 …
  std::string comment;               // at most 80 characters
  Position position;
};

class SymbolTable {
 public:
  SymbolTable() = default;
  explicit SymbolTable(Language language) : language_(language) {}

  Language language() const { return language_; }
  // False if the name is taken (compared without case, S7-OPEN-31).
  bool add(Symbol symbol);
  const Symbol* find(std::string_view name) const;
  // The symbol of an absolute operand, if any: for displays.
  const Symbol* findAddress(const SymbolAddress& address) const;
  const std::vector<Symbol>& list() const { return list_; }

 private:
  Language language_ = Language::Step7;
  std::vector<Symbol> list_;
  std::map<std::string, std::size_t> byName_;  // upper case
  std::map<SymbolAddress, std::size_t> byAddress_;
};

// "A 1.0", "MW10", "PEW 256", "T 1", "DB 5", "Q 1.0" … Operands that may not have a symbol (L, DBW,
// constants) give a problem (S7-SYM-06, -15). STEP 5: "PY 4", "PB 5" (a block), "DW 7", "D 3.15".
Result<SymbolAddress> parseSymbolAddress(std::string_view text, const Position& at,
                                         Language language = Language::Step7);

// Reads a symbol file into `table`, whose language says what operands are; the format follows the
// extension (.sdf .asc .seq .dif) or, for .sym and .txt, is the readable table of
// docs/formats/symbols.md. Problems: name longer than 24, comment longer than 80 characters, name
// twice, operand not allowed, type that does not fit the operand's width (S7-SYM-16).
void readSymbols(const SourceFile& file, SymbolTable& table, Problems& problems);
// By the extension; a .txt is taken for one only where it is named as such.
bool isSymbolFile(std::string_view path);

// The bytes of a file in one of these formats (".sdf", ".asc", ".seq", ".dif", ".sym"): CP1252 and
// CR LF as STEP 7 writes its exports, UTF-8 and LF for .sym. Empty for any other extension.
std::string writeSymbols(const SymbolTable& table, std::string_view extension, Mnemonics mnemonics);

}  // namespace merker::source
