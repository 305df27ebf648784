// Cutting a line of text at places that are not inside "…", '…', (…) or […]: operands and constants
// contain commas, signs and blanks of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "base/problem.h"

namespace merker::simulator {

// Where a part of a line stands in its file.
using PositionOf = std::function<Position(std::string_view)>;

// Offset of the first place outside of quotes and brackets where `match` (called with the rest of
// the text) is true; npos if there is none.
template <typename Match>
std::size_t findOutside(std::string_view text, Match match) {
  char quote = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == 0 && depth == 0 && match(text.substr(i))) return i;
    if (quote != 0) {
      if (c == '$' && quote == '\'')
        ++i;  // $' is a character of the text
      else if (c == quote)
        quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(' || c == '[') {
      ++depth;
    } else if ((c == ')' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return std::string_view::npos;
}

// The parts between commas, trimmed; one empty part for an empty text.
std::vector<std::string_view> splitList(std::string_view text);

// The line without its comment: # at the beginning or after a blank (W#16#5 has none before it).
std::string_view withoutComment(std::string_view line);

// Takes the first word (up to a blank) off `text`, which is trimmed before and after.
std::string_view takeWord(std::string_view& text);
// The same of a name, which may stand in quotation marks.
std::string_view takeName(std::string_view& text);

}  // namespace merker::simulator
