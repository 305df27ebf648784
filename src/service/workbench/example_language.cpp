#include "workbench/example_language.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/text.h"
#include "monitor/nowhere.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

// How a kind of file is written. `title`: the word that begins a heading, `behind`: what the
// heading stands behind.
struct Form {
  std::string_view ending;
  std::string_view comment, otherComment;
  std::string_view title, behind;
  // Whole texts in quotation marks are those of `name` and of numbers only; others are built of
  // names.
  bool settings;
};

constexpr Form kForms[] = {
    {".awl", "//", "", "TITLE", "=", false}, {".s5", "//", "! ", "NETZWERK", "  ", false},
    {".sym", "//", "", "", "", false},       {".vat", "//", "", "", "", false},
    {".hmi", "//", "", "", "", false},       {".scn", "# ", "", "", "", false},
    {".toml", "# ", "", "", "", true},
};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The blanks around it stay.
std::string germanWhole(std::string_view text, const Phrases::Words& words) {
  const std::string_view bare = trim(text);
  const auto found = words.find(bare);
  if (bare.empty() || found == words.end()) return std::string(text);
  const auto begin = static_cast<std::size_t>(bare.data() - text.data());
  return std::string(text.substr(0, begin)) + found->second +
         std::string(text.substr(begin + bare.size()));
}

// The word, the number or the single character that stands there.
std::string_view wordAt(std::string_view line, std::size_t at) {
  std::size_t end = at + 1;
  if (isLetter(line[at]) || isDigit(line[at]))
    while (end < line.size() && (isLetter(line[end]) || isDigit(line[end]))) ++end;
  return line.substr(at, end - at);
}

std::string germanNames(std::string_view text, const Phrases& phrases) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view word = wordAt(text, at);
    result += germanWhole(word, phrases.names);
    at += word.size();
  }
  return result;
}

// Where the heading begins; npos: the line is none.
std::size_t titleAt(std::string_view line, const Form& form) {
  if (form.title.empty() || !trim(line).starts_with(form.title)) return std::string_view::npos;
  const std::size_t at = line.find(form.behind);
  return at == std::string_view::npos ? at : at + form.behind.size();
}

bool startsComment(std::string_view rest, const Form& form) {
  return rest.starts_with(form.comment) ||
         (!form.otherComment.empty() && rest.starts_with(form.otherComment));
}

std::string germanCode(std::string_view line, const Form& form, const Phrases& phrases);

// A check, //=, is no text: it names variables.
std::string germanComment(std::string_view rest, const Form& form, const Phrases& phrases) {
  const std::string_view mark = rest.starts_with(form.comment) ? form.comment : form.otherComment;
  const std::string_view text = rest.substr(mark.size());
  return std::string(mark) + (text.starts_with('=') ? germanCode(text, form, phrases)
                                                    : germanWhole(text, phrases.texts));
}

// "Motor" with its quotation marks, from there on; the rest if it does not end.
std::string_view quotedAt(std::string_view line, std::size_t at) {
  const std::size_t end = line.find('"', at + 1);
  return line.substr(at, end == std::string_view::npos ? end : end - at + 1);
}

// name = "...", 6000 = "...": the setting that the text before it ends with.
bool isText(std::string_view before) {
  before = trim(before);
  if (!before.ends_with('=')) return false;
  before = trim(before.substr(0, before.size() - 1));
  const std::size_t start = before.find_last_of(" {,");
  const std::string_view key = start == std::string_view::npos ? before : before.substr(start + 1);
  return key == "name" || (!key.empty() && isDigit(key[0]));
}

std::string germanQuoted(std::string_view quoted, std::string_view before, const Form& form,
                         const Phrases& phrases) {
  if (quoted.size() < 2 || !quoted.ends_with('"')) return std::string(quoted);
  const std::string_view text = quoted.substr(1, quoted.size() - 2);
  // A station may have the name of its project.
  const bool isName = phrases.names.contains(text);
  const bool whole = !form.settings || (isText(before) && phrases.texts.contains(text) && !isName);
  return '"' + (whole ? germanWhole(text, phrases.texts) : germanNames(text, phrases)) + '"';
}

std::string germanCode(std::string_view line, const Form& form, const Phrases& phrases) {
  std::string result;
  for (std::size_t at = 0; at < line.size();) {
    if (startsComment(line.substr(at), form))
      return result + germanComment(line.substr(at), form, phrases);
    const bool quote = line[at] == '"';
    const std::string_view part = quote ? quotedAt(line, at) : wordAt(line, at);
    result += quote ? germanQuoted(part, line.substr(0, at), form, phrases)
                    : germanWhole(part, phrases.names);
    at += part.size();
  }
  return result;
}

std::string germanLine(std::string_view line, const Form& form, const Phrases& phrases) {
  const std::size_t title = titleAt(line, form);
  if (title == std::string_view::npos) return germanCode(line, form, phrases);
  return std::string(line.substr(0, title)) + germanWhole(line.substr(title), phrases.texts);
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

void translateFile(const fs::path& path, const Phrases& phrases) {
  const std::string text = readFile(path);
  const std::string made = translated(text, path.extension().string(), phrases);
  if (made != text) std::ofstream(path, std::ios::binary) << made;
}

void translateFolder(const fs::path& folder, const Phrases& phrases) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file(error)) translateFile(entry.path(), phrases);
}

std::vector<fs::path> filesNamed(const char* name, const std::string& folder,
                                 std::error_code& error) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.path().filename() == name) found.push_back(entry.path());
  return found;
}

}  // namespace

// "# " begins a comment of the list.
Phrases readPhrases(std::string_view text) {
  Phrases phrases;
  eachLine(text, [&](std::string_view line) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string_view::npos || line.starts_with("# ")) return std::string();
    const bool name = line.starts_with('#');
    (name ? phrases.names : phrases.texts)
        .emplace(line.substr(name ? 1 : 0, tab - (name ? 1 : 0)), trim(line.substr(tab + 1)));
    return std::string();
  });
  return phrases;
}

std::string translated(std::string_view text, std::string_view ending, const Phrases& phrases) {
  const auto* form = std::ranges::find(kForms, ending, &Form::ending);
  if (form == std::end(kForms)) return std::string(text);
  return eachLine(text, [&](std::string_view line) { return germanLine(line, *form, phrases); });
}

// Of a pair each has words of its own.
std::optional<Problem> finishCopy(const std::string& folder, bool german) {
  std::error_code error;
  for (const fs::path& text : filesNamed(kGermanReadme, folder, error))
    if (german)
      fs::rename(text, text.parent_path() / "README.md", error);
    else
      fs::remove(text, error);
  for (const fs::path& list : filesNamed(kGermanWords, folder, error)) {
    const Phrases phrases = readPhrases(readFile(list));
    fs::remove(list, error);
    if (german) translateFolder(list.parent_path(), phrases);
  }
  if (error) return makeProblem(ProblemCode::P1313, monitor::nowhere(), folder, error.message());
  return std::nullopt;
}

}  // namespace merker::workbench
