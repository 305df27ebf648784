#include "scenario/line.h"

#include "base/text.h"

namespace merker::simulator {

std::vector<std::string_view> splitList(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto comma = findOutside(text, [](std::string_view rest) { return rest[0] == ','; });
    parts.push_back(trim(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::string_view withoutComment(std::string_view line) {
  char before = ' ';
  const auto start = findOutside(line, [&](std::string_view rest) {
    const bool found = rest[0] == '#' && (before == ' ' || before == '\t');
    before = rest[0];
    return found;
  });
  return trim(line.substr(0, start));
}

std::string_view takeWord(std::string_view& text) {
  text = trim(text);
  const auto end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(word.size());
  text = trim(text);
  return word;
}

}  // namespace merker::simulator
