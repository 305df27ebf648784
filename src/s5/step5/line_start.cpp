#include "step5/line_start.h"

#include "step5/operation_word.h"

namespace merker::step5 {
namespace {

// Statements begin right behind the colon, comments at column 32 and beyond (FB 140 in 6.3).
constexpr std::size_t kCommentColumn = 16;
constexpr std::size_t kAddressDigits = 4;

}  // namespace

bool isComment(const Scanner& scanner) {
  const char c = scanner.peek();
  const bool mark = c == '!' && scanner.peek(1) != '=';  // !=F is an operation
  const char next = upper(scanner.peek(1));
  const bool star = c == '*' && next != 'F' && next != 'G';  // *F, *G
  return scanner.atEnd() || mark || c == ';' || star || (c == '/' && scanner.peek(1) == '/');
}

bool isNetworkEnd(std::string_view line) {
  Scanner scanner(line, 0);
  scanner.skipBlanks();
  const bool stars = scanner.take([](char c) { return c == '*'; }).size() == 3;
  scanner.skipBlanks();
  return stars && scanner.atEnd();
}

void skipAddress(Scanner& scanner) {
  const std::size_t mark = scanner.mark();
  const bool number = isDigit(scanner.peek());
  const std::size_t digits = scanner.take(isHexDigit).size();
  const bool separate = isBlank(scanner.peek()) || scanner.peek() == ':';
  if (!number || digits != kAddressDigits || !separate) return scanner.back(mark);
  scanner.skipBlanks();
}

bool continuesComment(const Scanner& scanner, std::size_t blanks) {
  if (scanner.peek() == '(' || scanner.peek() == '"') return true;
  Scanner word = scanner;
  std::optional<Failure> ignored;
  return blanks >= kCommentColumn && !isOperation(operationWord(word, ignored));
}

}  // namespace merker::step5
