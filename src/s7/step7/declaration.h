// The declaration part of a block as written, before names of UDTs and FBs are resolved.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "block/block.h"
#include "source/source_file.h"
#include "source/symbol_table.h"
#include "step7/cursor.h"

namespace merker::step7 {

struct VariableSyntax;

struct TypeSyntax {
  enum class Kind : std::uint8_t {
    Elementary,
    String,
    Array,
    Struct,
    Block,
    Symbol
  } kind = Kind::Elementary;
  TypeCode code = TypeCode::Void;
  std::uint16_t length = 254;  // STRING
  std::vector<block::Dimension> dimensions;
  std::shared_ptr<TypeSyntax> element;
  std::vector<VariableSyntax> members;
  BlockId block;       // UDT 3, FB 10, SFB 4
  std::string symbol;  // "Motor data"
  std::size_t begin = 0, end = 0;
  bool good = true;  // false: a problem is reported; without a code the type is unknown
};

struct VariableSyntax {
  std::string name;
  std::size_t begin = 0;                         // of the name
  std::shared_ptr<const TypeSyntax> type;        // one for all the names of a declaration
  std::size_t initialBegin = 0, initialEnd = 0;  // text behind :=, empty if none
  std::string comment;
  std::vector<std::pair<std::string, std::string>> attributes;
  block::Section section = block::Section::Static;
};

// Reads declarations; problems go to the list, reading goes on with the next line.
class DeclarationParser {
 public:
  // With a symbol list, a type may be a symbol without quotation marks.
  DeclarationParser(Cursor& cursor, const source::SourceFile& file, Problems& problems,
                    const source::SymbolTable* symbols)
      : cursor_(cursor), file_(file), problems_(problems), symbols_(symbols) {}

  // name {, name} [attributes] : type [:= value] ;   Several names give several variables.
  // False at the word that ends the list (END_VAR, END_STRUCT …), which stays.
  bool variables(block::Section section, std::vector<VariableSyntax>& out);
  std::optional<TypeSyntax> type();
  // { name := 'value' ; … }
  std::vector<std::pair<std::string, std::string>> attributes();

 private:
  void passStructure();
  std::optional<TypeSyntax> typeHere();
  std::optional<TypeSyntax> array(TypeSyntax syntax);
  std::optional<TypeSyntax> structure(TypeSyntax syntax);
  std::optional<TypeSyntax> string(TypeSyntax syntax);
  bool dimension(TypeSyntax& syntax);
  bool variableTail(std::vector<VariableSyntax>& names, std::vector<VariableSyntax>& out);
  void initialValue(VariableSyntax& variable);
  void endOfDeclaration(const VariableSyntax& variable, const TypeSyntax& type);
  TypeSyntax unknownType();
  std::string endOfLineComment();
  bool variableName(VariableSyntax& variable);
  Position at(std::size_t begin, std::size_t end) const {
    return file_.position(begin, end - begin);
  }
  void recover();

  Cursor& cursor_;
  const source::SourceFile& file_;
  Problems& problems_;
  const source::SymbolTable* symbols_;
  int depth_ = 0;
  bool tooMany_ = false;  // variables: told
};

// A word at which a list of declarations ends: END_VAR, END_STRUCT, BEGIN …
bool endsDeclarations(std::string_view word);
// Keyword of a block kind: OB, FB, FC, DB, UDT, SFB, SFC.
std::optional<BlockKind> blockKindFromName(std::string_view word);

// Whether a word without quotation marks is a symbol (S7-SYM-05) and not a block's kind or name.
bool isSymbolWord(std::string_view word, const source::SymbolTable* symbols);

// Signed decimal number at the cursor.
std::optional<std::int64_t> readInteger(Cursor& cursor);

}  // namespace merker::step7
