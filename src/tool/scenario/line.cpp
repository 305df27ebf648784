#include "scenario/line.h"

#include "base/text.h"

namespace merker::simulator {

namespace {

// Whether the comma at `at` is the one of a STEP 5 constant: KY 1,2.
bool insideKy(std::string_view text, std::size_t at) {
  constexpr std::string_view kDigits = "0123456789", kBlanks = " \t", kBefore = " \t=<>";
  const auto second = text.find_first_not_of(kBlanks, at + 1);
  if (second == std::string_view::npos || kDigits.find(text[second]) == std::string_view::npos)
    return false;
  std::string_view before = text.substr(0, at);
  const auto word = before.find_last_not_of(kDigits);
  if (word == std::string_view::npos || word + 1 == before.size()) return false;
  before = trim(before.substr(0, word + 1));
  if (before.size() < 2 || !equalsIgnoreCase(before.substr(before.size() - 2), "KY")) return false;
  return before.size() == 2 || kBefore.find(before[before.size() - 3]) != std::string_view::npos;
}

}  // namespace

// KY 1,2 is one constant.
std::vector<std::string_view> splitList(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto comma = findOutside(text, [text](std::string_view rest) {
      return rest[0] == ',' && !insideKy(text, text.size() - rest.size());
    });
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

std::string_view takeName(std::string_view& text) {
  if (!text.starts_with('"')) return takeWord(text);
  const auto end = text.find('"', 1);
  if (end == std::string_view::npos) return takeWord(text);
  const std::string_view name = text.substr(1, end - 1);
  text = trim(text.substr(end + 1));
  return name;
}

}  // namespace merker::simulator
