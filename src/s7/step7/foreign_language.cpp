#include "step7/foreign_language.h"

#include "base/text.h"
#include "step7/cursor.h"

namespace merker::step7 {
namespace {

struct ForeignWord {
  std::string_view word, language;
};
constexpr ForeignWord kForeignWords[] = {{"END_IF", "SCL"},           {"ELSIF", "SCL"},
                                         {"END_FOR", "SCL"},          {"END_WHILE", "SCL"},
                                         {"END_CASE", "SCL"},         {"END_REPEAT", "SCL"},
                                         {"END_CONST", "SCL"},        {"END_LABEL", "SCL"},
                                         {"END_REGION", "SCL"},       {"END_STEP", "GRAPH"},
                                         {"END_TRANSITION", "GRAPH"}, {"INITIAL_STEP", "GRAPH"}};

// IF, CASE, FOR, WHILE alone do not tell: a comment may lack its //.
const ForeignWord* foreignWord(std::string_view word) {
  if (word.size() < 5) return nullptr;
  for (const ForeignWord& row : kForeignWords)
    if (equalsIgnoreCase(row.word, word)) return &row;
  return nullptr;
}

std::string_view refusalOf(std::string_view language) {
  return language == "SCL" ? "SCL, which Merker does not compile,"
                           : "GRAPH, which Merker does not compile,";
}

}  // namespace

std::optional<ForeignText> foreignText(std::string_view source) {
  Cursor cursor(source, 0, source.size());
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
