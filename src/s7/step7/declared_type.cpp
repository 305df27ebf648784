// The type of a declaration: elementary, STRING, ARRAY, STRUCT, a block or a symbol.
#include "base/text.h"
#include "step7/declaration.h"

namespace merker::step7 {

// Deeper than STEP 7 nests (8); what is deeper still is refused before it fills the stack.
constexpr int kDeepest = 32;

// Its members are no variables of the structure around it.
void DeclarationParser::passStructure() {
  for (int open = 0; !cursor_.atEnd();) {
    cursor_.skipSpace();
    const std::size_t begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    if (equalsIgnoreCase(word, "STRUCT")) {
      ++open;
    } else if (equalsIgnoreCase(word, "END_STRUCT") && open > 0) {
      if (--open == 0) return;
    } else if (endsDeclarations(word) || (open == 0 && cursor_.peek() == ';')) {
      return cursor_.seek(begin);
    } else if (word.empty()) {
      cursor_.peek() == '\'' ? cursor_.passText() : void(cursor_.take());
    }
  }
}

std::optional<TypeSyntax> DeclarationParser::type() {
  if (depth_ >= kDeepest) {
    problems_.add(ProblemCode::P0202, at(cursor_.pos(), cursor_.pos() + 1), "the nesting of types",
                  fmt::format("1..{}", kDeepest));
    passStructure();
    return std::nullopt;
  }
  ++depth_;
  auto result = typeHere();
  --depth_;
  return result;
}

std::optional<TypeSyntax> DeclarationParser::typeHere() {
  cursor_.skipSpace();
  TypeSyntax syntax;
  syntax.begin = cursor_.pos();
  if (cursor_.accept('"')) {
    const std::size_t begin = cursor_.pos();
    while (!cursor_.atEnd() && cursor_.peek() != '"' && cursor_.peek() != '\n') cursor_.take();
    syntax.kind = TypeSyntax::Kind::Symbol;
    syntax.symbol = cursor_.slice(begin, cursor_.pos());
    cursor_.accept('"');
    syntax.end = cursor_.pos();
    return syntax;
  }
  std::string_view word = cursor_.word();
  syntax.end = cursor_.pos();
  if (equalsIgnoreCase(word, "ARRAY")) return array(std::move(syntax));
  if (equalsIgnoreCase(word, "STRUCT")) return structure(std::move(syntax));
  if (equalsIgnoreCase(word, "STRING")) return string(std::move(syntax));
  if (const auto code = typeFromName(word)) {
    syntax.code = *code;
    return syntax;
  }
  if (isSymbolWord(word, symbols_)) {
    problems_.add(ProblemCode::P0354, at(syntax.begin, syntax.end), word);
    syntax.kind = TypeSyntax::Kind::Symbol;
    syntax.symbol = word;
    return syntax;
  }
  // "UDT 3" or "UDT3"
  const std::size_t letters = word.find_first_of("0123456789");
  if (const auto kind = blockKindFromName(word.substr(0, letters))) {
    if (letters != std::string_view::npos) cursor_.seek(syntax.begin + letters);
    const auto number = readInteger(cursor_);
    syntax.end = cursor_.pos();
    const bool usable =
        *kind == BlockKind::UDT || *kind == BlockKind::FB || *kind == BlockKind::SFB;
    if (number && *number >= 0 && *number <= 65535 && usable) {
      syntax.kind = TypeSyntax::Kind::Block;
      syntax.block = {*kind, static_cast<std::uint16_t>(*number)};
      return syntax;
    }
  }
  problems_.add(ProblemCode::P0403, at(syntax.begin, std::max(cursor_.pos(), syntax.begin + 1)),
                std::string(cursor_.slice(syntax.begin, cursor_.pos())));
  return std::nullopt;
}

bool DeclarationParser::dimension(TypeSyntax& syntax) {
  const auto low = readInteger(cursor_);
  cursor_.skipSpace();
  const bool dots = cursor_.accept('.') && cursor_.accept('.');
  cursor_.skipSpace();
  const auto high = readInteger(cursor_);
  cursor_.skipSpace();
  if (!low || !dots || !high || *low > *high || *low < -32768 || *high > 32767) return false;
  syntax.dimensions.push_back({static_cast<std::int32_t>(*low), static_cast<std::int32_t>(*high)});
  return true;
}

std::optional<TypeSyntax> DeclarationParser::array(TypeSyntax syntax) {
  syntax.kind = TypeSyntax::Kind::Array;
  cursor_.skipSpace();
  if (!cursor_.accept('[')) {
    problems_.add(ProblemCode::P0301, at(cursor_.pos(), cursor_.pos() + 1), "[");
    return std::nullopt;
  }
  do {
    cursor_.skipSpace();
    const std::size_t begin = cursor_.pos();
    if (!dimension(syntax)) {
      problems_.add(ProblemCode::P0404, at(begin, std::max(begin + 1, cursor_.pos())));
      return std::nullopt;
    }
  } while (cursor_.accept(','));
  if (!cursor_.accept(']')) {
    problems_.add(ProblemCode::P0301, at(cursor_.pos(), cursor_.pos() + 1), "]");
    return std::nullopt;
  }
  if (syntax.dimensions.size() > 6) {  // S7-TYPES-20
    problems_.add(ProblemCode::P0405, at(syntax.begin, cursor_.pos()), syntax.dimensions.size());
    return std::nullopt;
  }
  cursor_.skipSpace();
  if (!cursor_.acceptWord("OF")) {
    problems_.add(ProblemCode::P0301, at(cursor_.pos(), cursor_.pos() + 1), "OF");
    return std::nullopt;
  }
  auto element = type();
  if (!element) return std::nullopt;
  if (element->kind == TypeSyntax::Kind::Array) {  // S7-TYPES-20
    problems_.add(ProblemCode::P0431, at(element->begin, element->end));
    return std::nullopt;
  }
  syntax.good = element->good;
  syntax.element = std::make_shared<TypeSyntax>(std::move(*element));
  syntax.end = cursor_.pos();
  return syntax;
}

std::optional<TypeSyntax> DeclarationParser::structure(TypeSyntax syntax) {
  syntax.kind = TypeSyntax::Kind::Struct;
  while (variables(block::Section::Static, syntax.members)) continue;
  if (!cursor_.acceptWord("END_STRUCT")) {
    if (!cursor_.unclosedComment())
      problems_.add(ProblemCode::P0406, at(syntax.begin, syntax.begin + 6));
    syntax.good = false;
  }
  syntax.end = cursor_.pos();
  return syntax;
}

std::optional<TypeSyntax> DeclarationParser::string(TypeSyntax syntax) {
  syntax.kind = TypeSyntax::Kind::String;
  syntax.code = TypeCode::String;
  if (!cursor_.accept('[')) return syntax;
  const std::size_t begin = cursor_.pos();
  const auto length = readInteger(cursor_);
  if (!length || *length < 1 || *length > 254 || !cursor_.accept(']')) {
    problems_.add(ProblemCode::P0407, at(begin, std::max(begin + 1, cursor_.pos())));
    return std::nullopt;
  }
  syntax.length = static_cast<std::uint16_t>(*length);
  syntax.end = cursor_.pos();
  return syntax;
}

}  // namespace merker::step7
