// The German words of an example: symbols, their comments, titles of blocks and networks. They
// stand in german.txt of the example, one phrase a line, English, a tab, German; a copy does not
// have it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/problem.h"

namespace merker::workbench {

constexpr const char* kGermanWords = "german.txt";

using Phrases = std::map<std::string, std::string, std::less<>>;

Phrases readPhrases(std::string_view text);
// Of a source, a symbol table, a scenario or a table of variables: what stands whole between
// quotation marks, behind // or behind TITLE =.
std::string translated(std::string_view text, const Phrases& phrases);
// Of merker.toml: the name of the project.
std::string translatedSettings(std::string_view text, const Phrases& phrases);
// The files of a fresh copy; the words go from it, whether they were wanted or not.
std::optional<Problem> finishCopy(const std::string& folder, bool german);

}  // namespace merker::workbench
