#include "step5/operation_word.h"

#include <algorithm>
#include <array>

#include "mc5/instruction.h"

namespace merker::step5 {
namespace {

// Operations that do not begin with a letter but for comparisons, and the bracket.
constexpr std::array<std::string_view, 9> kSigns{"+F", "+G", "-F", "-G", "*F",
                                                 "*G", ":F", ":G", ")"};
// "=>" is printed once for ">=" (9.3.5, OP-34).
constexpr std::array<std::string_view, 7> kComparisons{"!=", "><", ">=", "<=", ">", "<", "=>"};

bool startsWith(const Scanner& scanner, std::string_view sign) {
  for (std::size_t i = 0; i < sign.size(); ++i)
    if (upper(scanner.peek(i)) != sign[i]) return false;
  return true;
}

bool isRelation(char c) { return c == '!' || c == '<' || c == '>' || c == '='; }

bool isType(const Scanner& scanner) {
  const char c = upper(scanner.peek());
  return (c == 'F' || c == 'D' || c == 'G') && !isLetter(scanner.peek(1));
}

// ">F", and with the blanks of the printed lists: "> = F", "> <F".
std::string comparison(Scanner& scanner, std::optional<Failure>& warning) {
  const std::size_t mark = scanner.mark(), offset = scanner.offset();
  std::string sign;
  for (; isRelation(scanner.peek()); scanner.skipBlanks()) {
    sign += scanner.peek();
    scanner.skip();
  }
  const bool known =
      std::find(kComparisons.begin(), kComparisons.end(), sign) != kComparisons.end();
  if (!known || !isType(scanner)) {
    scanner.back(mark);
    return {};
  }
  const char type = upper(scanner.peek());
  scanner.skip();
  if (sign != "=>") return sign + type;
  warning = {ProblemCode::P1151, offset, scanner.since(mark).size(), sign + type,
             std::string(">=") + type};
  return std::string(">=") + type;
}

// NOP and its 0 or 1 are one word.
std::string withDigit(Scanner& scanner, std::string word) {
  const std::size_t mark = scanner.mark();
  scanner.skipBlanks();
  const char digit = scanner.peek();
  const bool whole = digit == '0' || digit == '1';
  if (!whole) scanner.back(mark);
  if (whole) scanner.skip();
  return whole ? word + ' ' + digit : word;
}

}  // namespace

std::string operationWord(Scanner& scanner, std::optional<Failure>& warning) {
  if (std::string word = comparison(scanner, warning); !word.empty()) return word;
  for (const std::string_view sign : kSigns)
    if (startsWith(scanner, sign)) {
      scanner.skip(sign.size());
      return std::string(sign);
    }
  if (scanner.accept('=')) return "=";
  std::string word = uppercase(scanner.take(isLetter));
  if ((word == "U" || word == "O") && scanner.accept('(')) word += '(';
  if (word == "XF" || word == "XG") word[0] = 'x';
  return word == "NOP" ? withDigit(scanner, word) : word;
}

bool isOperation(std::string_view word) {
  return std::any_of(mc5::operations().begin(), mc5::operations().end(),
                     [&](const mc5::OperationInfo& row) {
                       return row.name == word || (row.other == word && !word.empty());
                     });
}

}  // namespace merker::step5
