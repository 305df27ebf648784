// The German words of an example: comments, titles, symbols, names of scenarios and projects, texts
// of alarms; and names of variables, modules, plants and stations. They stand in german.txt of the
// example, one phrase a line, English, a tab, German; a copy does not have it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/problem.h"

namespace merker::workbench {

constexpr const char* kGermanWords = "german.txt";
// Where an example has it, it takes the place of README.md.
constexpr const char* kGermanReadme = "README.de.md";

struct Phrases {
  using Words = std::map<std::string, std::string, std::less<>>;

  Words texts;
  // Replaced wherever they stand as a word of their own: #Name in german.txt.
  Words names;
};

Phrases readPhrases(std::string_view text);
// The text of a file of a project; `ending` says how its comments and titles look: ".awl".
std::string translated(std::string_view text, std::string_view ending, const Phrases& phrases);
// The files of a fresh copy; the words go from it, whether they were wanted or not.
std::optional<Problem> finishCopy(const std::string& folder, bool german);

}  // namespace merker::workbench
