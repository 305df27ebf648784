#include "workbench/example_language.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "base/text.h"
#include "workbench/json.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

std::string germanWord(std::string_view text, const Phrases& phrases) {
  const auto found = phrases.find(text);
  return found == phrases.end() ? std::string(text) : found->second;
}

// The blanks around it stay.
std::string germanWhole(std::string_view text, const Phrases& phrases) {
  const std::string_view bare = trim(text);
  if (bare.empty()) return std::string(text);
  const auto begin = static_cast<std::size_t>(bare.data() - text.data());
  return std::string(text.substr(0, begin)) + germanWord(bare, phrases) +
         std::string(text.substr(begin + bare.size()));
}

// Where the heading of a block or network begins; npos: the line is none.
std::size_t titleAt(std::string_view line) {
  const std::string_view bare = trim(line);
  if (!bare.starts_with("TITLE")) return std::string_view::npos;
  return line.find('=') == std::string_view::npos ? std::string_view::npos : line.find('=') + 1;
}

// "Motor" with its quotation marks, from there on; the rest if it does not end.
std::string_view quotedAt(std::string_view line, std::size_t at) {
  const std::size_t end = line.find('"', at + 1);
  return line.substr(at, end == std::string_view::npos ? end : end - at + 1);
}

std::string germanLine(std::string_view line, const Phrases& phrases) {
  if (const std::size_t title = titleAt(line); title != std::string_view::npos)
    return std::string(line.substr(0, title)) + germanWhole(line.substr(title), phrases);
  std::string result;
  for (std::size_t at = 0; at < line.size();) {
    if (line.substr(at).starts_with("//"))
      return result + "//" + germanWhole(line.substr(at + 2), phrases);
    const std::string_view quoted = line[at] == '"' ? quotedAt(line, at) : line.substr(at, 1);
    const bool whole = quoted.size() > 2 && quoted.ends_with('"');
    result += whole ? '"' + germanWord(quoted.substr(1, quoted.size() - 2), phrases) + '"'
                    : std::string(quoted);
    at += quoted.size();
  }
  return result;
}

template <typename Change>
std::string eachLine(std::string_view text, const Change& change) {
  std::string result;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    result += change(line);
    text.remove_prefix(line.size());
    if (!text.empty()) result += '\n', text.remove_prefix(1);
  }
  return result;
}

std::string readFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool hasWords(const fs::path& path) {
  constexpr std::array<std::string_view, 6> kEndings = {".awl", ".sym", ".scn",
                                                        ".vat", ".hmi", ".toml"};
  return std::ranges::find(kEndings, path.extension().string()) != kEndings.end();
}

void translateFile(const fs::path& path, const Phrases& phrases) {
  const std::string text = readFile(path);
  const std::string made =
      path.extension() == ".toml" ? translatedSettings(text, phrases) : translated(text, phrases);
  if (made != text) std::ofstream(path, std::ios::binary) << made;
}

}  // namespace

Phrases readPhrases(std::string_view text) {
  Phrases phrases;
  eachLine(text, [&](std::string_view line) {
    const std::size_t tab = line.find('\t');
    if (!line.starts_with('#') && tab != std::string_view::npos)
      phrases.emplace(line.substr(0, tab), trim(line.substr(tab + 1)));
    return std::string();
  });
  return phrases;
}

std::string translated(std::string_view text, const Phrases& phrases) {
  return eachLine(text, [&](std::string_view line) { return germanLine(line, phrases); });
}

// A plant or a module keeps its name: scenarios call it by that.
std::string translatedSettings(std::string_view text, const Phrases& phrases) {
  bool done = false;
  return eachLine(text, [&](std::string_view line) {
    if (done || !trim(line).starts_with("name")) return std::string(line);
    done = true;
    return germanLine(line, phrases);
  });
}

std::optional<Problem> finishCopy(const std::string& folder, bool german) {
  const fs::path words = fs::path(folder) / kGermanWords;
  std::error_code error;
  if (!fs::exists(words, error)) return std::nullopt;
  const Phrases phrases = readPhrases(readFile(words));
  fs::remove(words, error);
  if (german)
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
      if (entry.is_regular_file(error) && hasWords(entry.path()))
        translateFile(entry.path(), phrases);
  if (error) return makeProblem(ProblemCode::P1313, nowhere(), folder, error.message());
  return std::nullopt;
}

}  // namespace merker::workbench
