#include "step5/line_end.h"

#include "step5/operation_word.h"
#include "step5/statement.h"

namespace merker::step5 {
namespace {

bool isMark(const Scanner& scanner) {
  const char c = scanner.peek();
  if (scanner.atEnd() || c == '!' || c == ';' || c == '*') return true;
  return c == '/' && scanner.peek(1) == '/';
}

bool ends(Scanner scanner) {
  scanner.skipBlanks();
  return isMark(scanner);
}

// "E 1.3", "PB 3"
bool isOperand(Scanner scanner) {
  Failure ignored;
  return beginsOperand(scanner) && parseOperand(scanner, ignored);
}

// "U E 1.3" with whatever follows, "TAK" with nothing behind.
bool isStatement(Scanner scanner) {
  Failure failure;
  std::optional<Failure> ignored;
  Scanner word = scanner;
  const std::string operation = operationWord(word, ignored);
  if ((isOperation(operation) || operation == "NOP") && ends(word)) return true;
  const auto statement = parseStatement(scanner, failure);
  return statement && statement->instruction.operand.kind != mc5::OperandKind::None;
}

}  // namespace

bool commentFollows(Scanner& scanner, Failure& failure) {
  const std::size_t blanks = scanner.skipBlanks();
  if (isMark(scanner)) return true;
  const char c = scanner.peek();
  const std::string text(
      scanner.rest().substr(0, scanner.rest().find_first_of("!;")).substr(0, 12));
  if (c == '.' && (isBlank(scanner.peek(1)) || scanner.peek(1) == '\0')) return true;
  const bool missing = c == '?' && scanner.peek(1) == '?';  // an operand that is still to come
  if (blanks == 0 || missing || isDigit(c) || c == '.' || c == '=' || c == ',')
    failure = {ProblemCode::P1111, scanner.offset(), 1, text, ""};
  else if (isOperand(scanner) || isStatement(scanner))
    failure = {ProblemCode::P1152, scanner.offset(), text.size(), text, ""};
  else
    return true;
  return false;
}

}  // namespace merker::step5
