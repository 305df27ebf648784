// Constants as operands: where one begins and ends.
#include "base/text.h"
#include "step7/declaration.h"
#include "step7/operand_parser.h"

namespace merker::step7 {

bool OperandParser::atConstant() {
  cursor_.skipBlanks();
  const char c = cursor_.peek();
  if (isDigit(c) || c == '\'' || c == '+' || c == '-') return true;
  if (!isWordStart(c)) return false;
  const std::size_t start = cursor_.pos();
  const std::string_view word = cursor_.word();
  const bool hash = cursor_.peek() == '#' && cursor_.peek(1) != '#';
  cursor_.seek(start);
  return hash || equalsIgnoreCase(word, "TRUE") || equalsIgnoreCase(word, "FALSE");
}

namespace {

// The characters that a constant may consist of, up to a separator. Blanks belong to it only where
// STEP 7 writes them: C# 100, P#M 10.0, B#(1, 2), - 5.
void passConstant(Cursor& cursor) {
  if (cursor.peek() == '\'') {
    cursor.take();
    while (!cursor.atEnd() && cursor.peek() != '\n' && cursor.peek() != '\r') {
      const char c = cursor.take();
      if (c == '$' && cursor.peek() != '\n')
        cursor.take();
      else if (c == '\'' && cursor.peek() == '\'')
        cursor.take();
      else if (c == '\'')
        break;
    }
    return;
  }
  if (cursor.peek() == '+' || cursor.peek() == '-') {
    cursor.take();
    cursor.skipBlanks();
  }
  bool pointer = false;
  for (;;) {
    const char c = cursor.peek();
    if (c == '#') {
      const char before = cursor.text()[cursor.pos() - 1];
      pointer = before == 'P' || before == 'p';
      cursor.take();
      cursor.skipBlanks();
      if (cursor.peek() == '(') {
        while (!cursor.atStatementEnd() && cursor.take() != ')') continue;
        return;
      }
      continue;
    }
    // The sign of an exponent (1.5E-3), of L#-5 and of T#-1S; the dashes of D#1998-04-14.
    if (isWordChar(c) || c == '.' || (c == ':' && cursor.peek(1) != '=') || c == '-' || c == '+') {
      cursor.take();
      continue;
    }
    if (c == ' ' && pointer) {
      const std::size_t start = cursor.pos();
      cursor.skipBlanks();
      if (isDigit(cursor.peek()) && !isDigit(cursor.text()[start - 1])) continue;
      cursor.seek(start);
    }
    return;
  }
}

}  // namespace

namespace {

// "BYTE 4" behind a pointer, which makes an area of it.
bool passAreaLength(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  cursor.skipBlanks();
  if (typeFromName(cursor.word()) && readInteger(cursor)) return true;
  cursor.seek(start);
  return false;
}

bool isPointerIntoBlock(std::string_view text) {
  return text.size() > 4 && equalsIgnoreCase(text.substr(0, 4), "P#DB") && isDigit(text[4]);
}

}  // namespace

std::optional<Access> OperandParser::constantOperand() {
  const std::size_t begin = cursor_.pos();
  passConstant(cursor_);
  const std::string_view pointer = cursor_.slice(begin, cursor_.pos());
  const bool isPointer = pointer.size() > 1 && equalsIgnoreCase(pointer.substr(0, 2), "P#");
  const bool area = isPointer && passAreaLength(cursor_);
  if (area || isPointerIntoBlock(pointer))
    return problem(ProblemCode::P0353, begin, std::string(cursor_.slice(begin, cursor_.pos())));
  const auto value = parseConstant(cursor_.slice(begin, cursor_.pos()), at(begin, cursor_.pos()));
  if (!value) {
    problems_.add(value.error());
    return std::nullopt;
  }
  return simple(mc7::constant(value->format, value->bits));
}

}  // namespace merker::step7
