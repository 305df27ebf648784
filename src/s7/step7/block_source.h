// One block of a source as written: header, declarations, and where its code stands. First pass of
// the compiler.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "block/block.h"
#include "source/symbol_table.h"
#include "step7/declaration.h"

namespace merker::step7 {

// A block's name as written: OB 1, FC12 or "Symbol".
struct BlockName {
  std::optional<BlockId> id;  // nothing if the symbol is unknown
  std::string symbol;
  std::size_t begin = 0, end = 0;
};

struct BlockSource {
  const source::SourceFile* file = nullptr;
  std::uint32_t fileIndex = 0;
  BlockId id;
  BlockName name;
  block::Attributes attributes;
  std::vector<VariableSyntax> variables;
  std::optional<TypeSyntax> returnType;    // FC
  std::optional<TypeSyntax> dataType;      // DB, UDT: STRUCT …, UDT n, FB n
  std::size_t codeBegin = 0, codeEnd = 0;  // between BEGIN and END_…; for a DB the assignments
  Mnemonics mnemonics = Mnemonics::German;
  bool duplicate = false;  // another block has the number: no code is made
};

// Splits a source into its blocks. Everything between BEGIN and END_… stays text.
class BlockSplitter {
 public:
  BlockSplitter(const source::SourceFile& file, const source::SymbolTable* symbols,
                Problems& problems)
      : file_(file),
        symbols_(symbols),
        problems_(problems),
        cursor_(file.text(), 0, file.text().size(), problems.stop()) {}

  std::vector<BlockSource> split();

 private:
  struct Frame;
  void block(const Frame& frame, std::size_t begin);
  bool blockName(const Frame& frame, BlockSource& block);
  void systemAttributes(BlockSource& block);
  void header(BlockSource& block);
  void blockComment(BlockSource& block);
  bool headerLine(BlockSource& block);
  void declarations(const Frame& frame, BlockSource& block);
  void declarationSection(BlockSource& block, block::Section section, std::size_t begin);
  void dataDeclaration(BlockSource& block);
  void code(const Frame& frame, BlockSource& block);
  void checkSectionOrder(const BlockSource& block, block::Section section, std::size_t begin);
  std::string restOfLine();
  std::string headerValue();
  Position at(std::size_t begin, std::size_t end) const {
    return file_.position(begin, std::max(end, begin + 1) - begin);
  }

  const source::SourceFile& file_;
  const source::SymbolTable* symbols_;
  Problems& problems_;
  Cursor cursor_;
  std::vector<BlockSource> blocks_;
};

// Reads OB 1, FC12, "Symbol" or a symbol of the list without quotation marks at the cursor. Problem
// if it is none of them or the symbol is unknown.
std::optional<BlockName> readBlockName(Cursor& cursor, const source::SourceFile& file,
                                       const source::SymbolTable* symbols, Problems& problems);

// Which mnemonics a source uses (S7-SRC-10): by the words that exist in only one of them; German if
// none.
Mnemonics detectMnemonics(std::string_view text, const std::vector<BlockSource>& blocks);

}  // namespace merker::step7
