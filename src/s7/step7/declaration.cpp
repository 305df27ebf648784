#include "step7/declaration.h"

#include <charconv>

#include "base/text.h"

namespace merker::step7 {

std::optional<BlockKind> blockKindFromName(std::string_view word) {
  for (const BlockKind kind : {BlockKind::OB, BlockKind::FB, BlockKind::FC, BlockKind::DB,
                               BlockKind::UDT, BlockKind::SFB, BlockKind::SFC})
    if (equalsIgnoreCase(word, name(kind))) return kind;
  return std::nullopt;
}

bool isSymbolWord(std::string_view word, const source::SymbolTable* symbols) {
  const std::size_t letters = word.find_first_of("0123456789");
  const bool block = blockKindFromName(word.substr(0, letters)) &&
                     word.find_first_not_of("0123456789", letters) == std::string_view::npos;
  return !block && symbols && symbols->find(word);
}

std::optional<std::int64_t> readInteger(Cursor& cursor) {
  cursor.skipBlanks();
  const std::size_t start = cursor.pos();
  if (cursor.peek() == '-' || cursor.peek() == '+') cursor.take();
  const std::size_t digits = cursor.pos();
  while (isDigit(cursor.peek())) cursor.take();
  std::string_view text = cursor.slice(start, cursor.pos());
  if (text.starts_with('+')) text.remove_prefix(1);
  std::int64_t value = 0;
  if (digits == cursor.pos() ||
      std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    cursor.seek(start);
    return std::nullopt;
  }
  return value;
}

bool endsDeclarations(std::string_view word) {
  static constexpr std::string_view kEnds[] = {"END_VAR",
                                               "END_STRUCT",
                                               "END_TYPE",
                                               "BEGIN",
                                               "VAR",
                                               "VAR_INPUT",
                                               "VAR_OUTPUT",
                                               "VAR_IN_OUT",
                                               "VAR_TEMP",
                                               "END_FUNCTION",
                                               "END_FUNCTION_BLOCK",
                                               "END_ORGANIZATION_BLOCK",
                                               "END_DATA_BLOCK",
                                               "FUNCTION",
                                               "FUNCTION_BLOCK",
                                               "ORGANIZATION_BLOCK",
                                               "DATA_BLOCK",
                                               "NETWORK"};
  for (const std::string_view end : kEnds)
    if (equalsIgnoreCase(word, end)) return true;
  return false;
}

// Of one list: a block of 64 KB has more bits, but no program so many names.
constexpr std::size_t kMostVariables = 20'000;
// Bytes that are kept; a declaration of many names has it many times.
constexpr std::size_t kLongestComment = 1000;

void DeclarationParser::recover() {
  while (!cursor_.atStatementEnd()) cursor_.take();
  cursor_.accept(';');
}

std::vector<std::pair<std::string, std::string>> DeclarationParser::attributes() {
  std::vector<std::pair<std::string, std::string>> result;
  cursor_.skipSpace();
  if (cursor_.peek() != '{') return result;
  const std::size_t open = cursor_.pos();
  cursor_.take();
  while (!cursor_.atEnd() && cursor_.peek() != '}') {
    const std::size_t begin = cursor_.pos();
    while (!cursor_.atEnd() && cursor_.peek() != '}' && cursor_.peek() != ';') {
      if (cursor_.take() != '\'') continue;
      while (!cursor_.atEnd() && cursor_.take() != '\'') continue;
    }
    const std::string_view item = cursor_.slice(begin, cursor_.pos());
    const std::size_t assign = item.find(":=");
    if (assign != std::string_view::npos)
      result.emplace_back(trim(item.substr(0, assign)), trim(item.substr(assign + 2)));
    cursor_.accept(';');
    cursor_.skipSpace();
  }
  if (!cursor_.accept('}')) problems_.add(ProblemCode::P0301, at(open, open + 1), "}");
  return result;
}

bool DeclarationParser::variableName(VariableSyntax& variable) {
  cursor_.skipSpace();
  variable.begin = cursor_.pos();
  if (cursor_.accept('#')) variable.begin = cursor_.pos();
  if (cursor_.peek() == '"') {
    cursor_.take();
    const std::size_t begin = cursor_.pos();
    while (!cursor_.atEnd() && cursor_.peek() != '"' && cursor_.peek() != '\n') cursor_.take();
    variable.name = cursor_.slice(begin, cursor_.pos());
    return cursor_.accept('"') && !variable.name.empty();
  }
  variable.name = cursor_.word();
  return !variable.name.empty();
}

bool DeclarationParser::variables(block::Section section, std::vector<VariableSyntax>& out) {
  cursor_.skipSpace();
  if (cursor_.atEnd()) return false;
  const std::size_t start = cursor_.pos();
  if (endsDeclarations(cursor_.word())) {
    cursor_.seek(start);
    return false;
  }
  cursor_.seek(start);
  if (cursor_.accept(';')) return true;
  std::vector<VariableSyntax> names;
  do {
    if (names.size() + out.size() == kMostVariables) {
      if (!tooMany_)
        problems_.add(ProblemCode::P0106, at(cursor_.pos(), cursor_.pos() + 1), kMostVariables,
                      "variables in this declaration");
      tooMany_ = true;
      recover();
      return true;
    }
    VariableSyntax variable;
    variable.section = section;
    if (!variableName(variable)) {
      problems_.add(ProblemCode::P0401, at(cursor_.pos(), cursor_.pos() + 1));
      if (cursor_.atStatementEnd()) cursor_.take();
      recover();
      return true;
    }
    variable.attributes = attributes();
    names.push_back(std::move(variable));
  } while (cursor_.accept(','));
  return variableTail(names, out);
}

bool DeclarationParser::variableTail(std::vector<VariableSyntax>& names,
                                     std::vector<VariableSyntax>& out) {
  cursor_.skipSpace();
  std::optional<TypeSyntax> syntax;
  if (cursor_.accept(':'))
    syntax = type();
  else
    problems_.add(ProblemCode::P0402, at(cursor_.pos(), cursor_.pos() + 1), names.back().name);
  VariableSyntax pattern;
  pattern.name = names.back().name;
  if (!syntax)
    syntax = unknownType();
  else if (syntax->good)
    initialValue(pattern);
  if (syntax->good) endOfDeclaration(pattern, *syntax);
  const std::string comment = endOfLineComment();
  const auto type = std::make_shared<const TypeSyntax>(std::move(*syntax));
  for (VariableSyntax& variable : names) {
    variable.type = type;
    variable.initialBegin = pattern.initialBegin;
    variable.initialEnd = pattern.initialEnd;
    variable.comment = comment;
    out.push_back(std::move(variable));
  }
  return true;
}

void DeclarationParser::initialValue(VariableSyntax& variable) {
  const std::size_t before = cursor_.pos();
  cursor_.skipSpace();
  if (cursor_.peek() == ':' && cursor_.peek(1) == '=') {
    cursor_.take();
    cursor_.take();
    cursor_.skipSpace();
    variable.initialBegin = cursor_.pos();
    // An array's list may go on over several lines, up to the semicolon.
    while (!cursor_.atEnd() && cursor_.peek() != ';') {
      const char c = cursor_.peek();
      if (c == '\'')
        cursor_.passText();
      else
        cursor_.take();
      cursor_.skipBlanks();
      if (!cursor_.atLineEnd()) continue;
      const std::size_t lineEnd = cursor_.pos();
      if (c == ',' || c == '(') {
        cursor_.skipSpace();
        continue;
      }
      cursor_.skipSpace();
      if (cursor_.peek() == ',' || cursor_.peek() == ')') continue;
      cursor_.seek(lineEnd);
      break;
    }
    variable.initialEnd = cursor_.pos();
    if (variable.initialEnd == variable.initialBegin)
      problems_.add(ProblemCode::P0412, at(cursor_.pos(), cursor_.pos() + 1), "nothing",
                    "this variable");
  } else {
    cursor_.seek(before);
  }
}

// The names stay declared, so that their uses are no further problems.
TypeSyntax DeclarationParser::unknownType() {
  TypeSyntax unknown;
  unknown.good = false;
  unknown.begin = unknown.end = cursor_.pos();
  recover();
  return unknown;
}

// The semicolon may be left out only behind END_STRUCT.
void DeclarationParser::endOfDeclaration(const VariableSyntax& variable, const TypeSyntax& type) {
  const std::size_t end = cursor_.pos();
  cursor_.skipSpace();
  if (cursor_.accept(';')) return;
  const bool anotherLine = (cursor_.seek(end), cursor_.atLineEnd());
  const bool closes = (cursor_.seek(end), cursor_.skipSpace(), endsDeclarations(cursor_.word()));
  cursor_.seek(end);
  if (anotherLine || closes) {
    if (type.kind != TypeSyntax::Kind::Struct)
      problems_.add(ProblemCode::P0349, at(end - 1, end), variable.name);
    return;
  }
  cursor_.skipBlanks();
  problems_.add(ProblemCode::P0302, at(cursor_.pos(), cursor_.pos() + 1),
                std::string(1, cursor_.peek()));
  recover();
}

std::string DeclarationParser::endOfLineComment() {
  cursor_.skipBlanks();
  if (cursor_.peek() != '/' || cursor_.peek(1) != '/') return {};
  const std::size_t begin = cursor_.pos() + 2;
  cursor_.skipLine();
  return std::string(trim(cursor_.slice(begin, std::min(cursor_.pos(), begin + kLongestComment))));
}

}  // namespace merker::step7
