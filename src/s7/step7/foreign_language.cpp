#include "step7/foreign_language.h"

#include <algorithm>

#include "base/text.h"
#include "step7/cursor.h"

namespace merker::step7 {
namespace {

struct ForeignWord {
  std::string_view word, language;
};
constexpr ForeignWord kForeignWords[] = {
    {"END_IF", "SCL"},     {"END_FOR", "SCL"},         {"END_WHILE", "SCL"}, {"END_CASE", "SCL"},
    {"END_REPEAT", "SCL"}, {"END_CONST", "SCL"},       {"END_LABEL", "SCL"}, {"END_REGION", "SCL"},
    {"END_STEP", "GRAPH"}, {"END_TRANSITION", "GRAPH"}};

constexpr std::string_view kEnd = "END_";

// IF, CASE, FOR, WHILE alone do not tell: a comment may lack its //.
const ForeignWord* foreignWord(std::string_view word) {
  for (const ForeignWord& row : kForeignWords)
    if (equalsIgnoreCase(row.word, word)) return &row;
  return nullptr;
}

std::string_view refusalOf(std::string_view language) {
  return language == "SCL" ? "SCL, which Merker does not compile,"
                           : "GRAPH, which Merker does not compile,";
}

// Whether such a word stands anywhere: hardly any source of AWL has to be read for its statements.
bool mayBeForeign(std::string_view source) {
  for (std::size_t at = source.find('_'); at != std::string_view::npos;
       at = source.find('_', at + 1)) {
    const std::size_t begin = at + 1 - std::min(at + 1, kEnd.size());
    std::size_t end = at;
    if (!equalsIgnoreCase(source.substr(begin, kEnd.size()), kEnd)) continue;
    while (end < source.size() && isWordChar(source[end])) ++end;
    if (foreignWord(source.substr(begin, end - begin)) != nullptr) return true;
  }
  return false;
}

}  // namespace

std::optional<ForeignText> foreignText(std::string_view source, const std::stop_token& stop) {
  if (!mayBeForeign(source)) return std::nullopt;
  Cursor cursor(source, 0, source.size(), stop);
  for (;;) {
    cursor.skipSpace();
    if (cursor.atEnd()) return std::nullopt;
    const std::size_t begin = cursor.pos();
    if (const ForeignWord* row = foreignWord(cursor.word())) {
      cursor.skipBlanks();
      if (cursor.peek() != ':')  // a label or a variable
        return ForeignText{row->language, refusalOf(row->language), begin,
                           begin + row->word.size()};
    }
    // To the next statement: behind ';' or on the next line.
    while (!cursor.atEnd() && cursor.peek() != ';' && cursor.peek() != '\n' &&
           cursor.peek() != '\r') {
      if (cursor.peek() == '\'')
        cursor.passText();
      else if (cursor.peek() == '/' && cursor.peek(1) == '/')
        cursor.skipLine();
      else
        cursor.take();
    }
    cursor.accept(';');
  }
}

}  // namespace merker::step7
