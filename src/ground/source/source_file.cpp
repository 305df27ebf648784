#include "source/source_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/code_page.h"
#include "base/utf8.h"
#include "base/visible.h"

namespace merker::source {
namespace {

constexpr std::uint64_t kMegabyte = 1024 * 1024;

constexpr std::size_t kChunk = 1024;
constexpr std::size_t kLongestShown = 400;  // bytes of a line that is shown whole
constexpr std::size_t kShownAround = 80;    // characters on each side of the place in a longer one

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::uint32_t countContinuations(std::string_view text) {
  return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), isContinuation));
}

std::vector<std::uint32_t> continuationTable(std::string_view text) {
  std::vector<std::uint32_t> table;
  if (isAscii(text)) return table;
  std::uint32_t total = 0;
  for (std::size_t i = 0; i < text.size(); i += kChunk) {
    table.push_back(total);
    total += countContinuations(text.substr(i, kChunk));
  }
  table.push_back(total);
  return table;
}

const char* find(const char* from, const char* end, char c) {
  const void* const found = std::memchr(from, c, static_cast<std::size_t>(end - from));
  return found ? static_cast<const char*>(found) : end;
}

// Starts of lines behind each CR LF, LF or CR; an end of line at the end of the text starts none.
std::vector<std::size_t> lineStarts(std::string_view text) {
  std::vector<std::size_t> starts{0};
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  for (const char* line = begin; line != end;) {
    const char* const feed = find(line, end, '\n');
    // A CR that no LF follows ends a line as well (old Macintosh and some terminal programs).
    for (const char* cr = find(line, feed, '\r'); cr != feed; cr = find(cr + 1, feed, '\r'))
      if (cr + 1 != feed || feed == end) starts.push_back(static_cast<std::size_t>(cr + 1 - begin));
    line = feed == end ? end : feed + 1;
    if (feed != end) starts.push_back(static_cast<std::size_t>(line - begin));
  }
  if (starts.size() > 1 && starts.back() == text.size()) starts.pop_back();
  return starts;
}

std::string_view withoutLineEnd(std::string_view line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  return line;
}

Problem unreadable(const std::string& path, const std::string& reason) {
  return makeProblem(ProblemCode::P0101, Position{path}, path, reason);
}

// What the file is by its name, for problems.
std::string_view kindOf(const std::filesystem::path& path) {
  static constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
      {".awl", "an AWL source"}, {".s5", "a STEP 5 listing"}, {".toml", "a project file"},
      {".scn", "a scenario"},    {".sdf", "a symbol file"},   {".asc", "a symbol file"},
      {".seq", "a symbol file"}, {".dif", "a symbol file"},   {".sym", "a symbol file"}};
  for (const auto& [extension, kind] : kKinds)
    if (equalsIgnoreCase(path.extension().string(), extension)) return kind;
  return "a source";
}

Result<std::string> readBytes(const std::string& path, std::size_t largest) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return unreadable(path, "no such file");
  if (std::filesystem::is_directory(status)) return unreadable(path, "it is a directory");
  // A pipe would wait for a writer, a device may have no end.
  if (!std::filesystem::is_regular_file(status))
    return unreadable(path, "it is not a regular file");
  std::ifstream in(path, std::ios::binary);
  if (!in) return unreadable(path, "access denied");
  // Not by the size of the file alone: it may grow, and those below /proc have none.
  std::string bytes;
  std::vector<char> buffer(kMegabyte);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    bytes.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > largest * kMegabyte)
      return makeProblem(ProblemCode::P0103, Position{path}, largest, kindOf(path));
  }
  if (in.bad()) return unreadable(path, "reading failed");
  return bytes;
}

std::string place(const Position& position) {
  if (position.file.empty()) return {};
  const std::string file = visible(position.file);
  if (position.line == 0) return file + ": ";
  if (position.column == 0) return fmt::format("{}:{}: ", file, position.line);
  return fmt::format("{}:{}:{}: ", file, position.line, position.column);
}

// The line as it is shown: control characters would upset a terminal.
std::string printable(std::string_view line) {
  std::string result(line);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 && c != '\t') c = ' ';
  return result;
}

std::string_view takeCharacters(std::string_view& text, std::size_t count) {
  std::size_t bytes = 0;
  while (bytes < text.size() && (count > 0 || isContinuation(text[bytes]))) {
    if (!isContinuation(text[bytes])) --count;
    ++bytes;
  }
  const std::string_view result = text.substr(0, bytes);
  text.remove_prefix(bytes);
  return result;
}

struct Excerpt {
  std::string text;
  std::size_t column;  // of the place in it
};

// The line, or of a very long one the surroundings of the place.
Excerpt excerpt(std::string_view line, std::size_t column) {
  if (line.size() <= kLongestShown) return {printable(line), column};
  const std::size_t skipped = column > kShownAround ? column - kShownAround : 0;
  takeCharacters(line, skipped);
  const std::string_view shown = takeCharacters(line, 2 * kShownAround);
  const std::string before = skipped > 0 ? "..." : "";
  return {before + printable(shown) + (line.empty() ? "" : "..."),
          column - skipped + before.size()};
}

// Tabs stay tabs, so the caret stands under its place whatever their width is.
std::string caretLine(std::string_view line, std::size_t column, std::size_t length) {
  const std::size_t width = characterCount(line);
  std::string result;
  for (const char c : takeCharacters(line, column - 1))
    if (!isContinuation(c)) result += c == '\t' ? '\t' : ' ';
  const std::size_t room = width >= column ? width - column + 1 : 1;
  return result + '^' + std::string(std::clamp<std::size_t>(length, 1, room) - 1, '~');
}

}  // namespace

SourceFile::SourceFile(std::string name, std::string utf8)
    : name_(std::move(name)),
      text_(std::move(utf8)),
      starts_(lineStarts(text_)),
      continuations_(continuationTable(text_)) {}

std::string_view SourceFile::line(std::uint32_t number) const {
  if (number == 0 || number > starts_.size()) return {};
  const std::size_t end = number < starts_.size() ? starts_[number] : text_.size();
  return withoutLineEnd(
      std::string_view(text_).substr(starts_[number - 1], end - starts_[number - 1]));
}

// How many characters begin in [from, to).
std::size_t SourceFile::characters(std::size_t from, std::size_t to) const {
  if (continuations_.empty()) return to - from;
  const auto before = [this](std::size_t offset) {
    const std::size_t chunk = offset / kChunk;
    const std::string_view rest = std::string_view(text_).substr(chunk * kChunk, offset % kChunk);
    return offset - continuations_[chunk] - countContinuations(rest);
  };
  return before(to) - before(from);
}

Position SourceFile::position(std::size_t offset, std::size_t length) const {
  offset = std::min(offset, text_.size());
  const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto number = static_cast<std::uint32_t>(next - starts_.begin());
  const std::size_t start = starts_[number - 1];
  const std::size_t end = start + line(number).size();
  offset = std::min(offset, end);
  Position result{name_, number};
  result.column = static_cast<std::uint32_t>(characters(start, offset) + 1);
  const std::size_t width = characters(offset, offset + std::min(length, end - offset));
  result.length = static_cast<std::uint32_t>(std::max<std::size_t>(width, 1));
  return result;
}

Result<SourceFile> readSource(const std::string& path, std::size_t largest) {
  auto bytes = readBytes(path, largest);
  if (!bytes) return bytes.error();
  // DOS editors end a text with Ctrl-Z.
  while (bytes->ends_with('\x1A')) bytes->pop_back();
  auto text = decoded(*bytes);
  if (!text) return makeProblem(ProblemCode::P0102, Position{path}, kindOf(path));
  return SourceFile(path, std::move(*text));
}

std::string format(const Problem& problem, const SourceFile* file) {
  const Position& at = problem.position;
  const auto* const severity = problem.severity() == Severity::Error ? "error" : "warning";
  std::string result =
      fmt::format("{}{}: {} [{}]", place(at), severity, problem.message, problem.name());
  if (file == nullptr || at.line == 0 || at.line > file->lineCount()) return result;
  const Excerpt shown = excerpt(file->line(at.line), at.column);
  result += '\n' + shown.text;
  if (at.column > 0) result += '\n' + caretLine(shown.text, shown.column, at.length);
  return result;
}

}  // namespace merker::source
