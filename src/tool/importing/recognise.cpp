#include "importing/recognise.h"

#include <algorithm>
#include <array>

#include "base/bytes.h"
#include "base/code_page.h"
#include "base/text.h"
#include "importing/file_text.h"

namespace merker::importing {
namespace {

constexpr std::size_t kLooked = 64u << 10;

bool isContainer(const archive::File& file) {
  std::array<std::uint8_t, 36> head{};
  if (file.read(0, head) < head.size()) return false;
  const std::uint32_t length = loadDWord(&head[8]);
  return head[0] == 0x70 && head[1] == 0x70 && length >= 72 && length <= file.size();
}

// The first word of a line that is not a comment.
std::string_view firstWord(std::string_view line) {
  line = trim(line);
  return line.substr(0, line.find_first_of(" \t\"(:;"));
}

bool beginsBlock(std::string_view word) {
  for (const std::string_view keyword :
       {"ORGANIZATION_BLOCK", "FUNCTION", "FUNCTION_BLOCK", "DATA_BLOCK", "TYPE"})
    if (equalsIgnoreCase(word, keyword)) return true;
  return false;
}

// Four fields in quotation marks.
bool isSdf(std::string_view line) {
  line = trim(line);
  std::size_t fields = 1;
  for (std::size_t at = 0; (at = line.find("\",\"", at)) != std::string_view::npos; at += 3)
    ++fields;
  return line.size() > 8 && line.front() == '"' && line.back() == '"' && fields == 4;
}

bool isAsc(std::string_view line) { return line.starts_with("126,") && line.size() > 30; }

// A tab, operand, tab, name.
bool isSeq(std::string_view line) {
  return line.starts_with('\t') && std::count(line.begin(), line.end(), '\t') >= 2;
}

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::size_t digitsAt(std::string_view text) {
  return std::min(text.find_first_not_of("0123456789"), text.size());
}

// "PB 5", "FB 7 VENTIL": the first line of a block of STEP 5.
bool headsListing(std::string_view line) {
  static constexpr std::string_view kKinds[] = {"OB", "PB", "SB", "FB", "FX", "DB", "DX"};
  line = trim(line);
  if (std::ranges::none_of(kKinds, [&](std::string_view kind) {
        return equalsIgnoreCase(line.substr(0, kind.size()), kind);
      }))
    return false;
  line = trim(line.substr(2));
  const std::size_t digits = digitsAt(line);
  return digits > 0 && (digits == line.size() || line[digits] == ' ' || line[digits] == '\t');
}

// The end of a code block, or a word of a data block: "   0: KF +5".
bool isOfListing(std::string_view line) {
  line = trim(line);
  if (line.starts_with(':')) line = trim(line.substr(1));
  const std::size_t digits = digitsAt(line);
  if (digits > 0) return trim(line.substr(digits)).starts_with(':');
  const std::string_view word = firstWord(line);
  return equalsIgnoreCase(word, "BE") || equalsIgnoreCase(word, "BEND");
}

// Behind its first line.
bool isListing(std::string_view text) {
  while (!text.empty())
    if (isOfListing(takeLine(text))) return true;
  return false;
}

Kind ofText(std::string_view text) {
  bool first = true;
  while (!text.empty()) {
    const std::string_view line = takeLine(text);
    if (trim(line).empty() || trim(line).starts_with("//") || trim(line).starts_with('!')) continue;
    const std::string_view word = firstWord(line);
    if (beginsBlock(word)) return Kind::AwlSource;
    if (first) {
      if (equalsIgnoreCase(word, "FILEVERSION")) return Kind::Hardware;
      if (isSdf(line)) return Kind::Sdf;
      if (isAsc(line)) return Kind::Asc;
      if (equalsIgnoreCase(trim(line), "TABLE")) return Kind::Dif;
      if (isSeq(line)) return Kind::Seq;
      if (headsListing(line) && isListing(text)) return Kind::Listing;
    }
    if (equalsIgnoreCase(word, "STATION")) return Kind::Hardware;
    first = false;
  }
  return Kind::Unknown;
}

// Its columns stand behind tabs or in fixed places.
bool isAssignmentList(std::string_view path, Kind kind, std::string_view text) {
  const bool list = kind == Kind::Seq || (kind == Kind::Unknown && !trim(text).empty() &&
                                          text.find('\0') == std::string_view::npos);
  return list && archive::folded(archive::nameOf(path)).ends_with("z0.seq");
}

}  // namespace

Kind recognise(const archive::File& file, std::string_view path) {
  if (isContainer(file)) return Kind::Containers;
  std::string bytes = file.text(kLooked);
  if (const auto text = decoded(withoutZeros(bytes))) {
    const Kind kind = ofText(*text);
    return isAssignmentList(path, kind, *text) ? Kind::Assignments : kind;
  }
  std::ranges::replace_if(
      bytes, [](char c) { return c >= 0 && c < '\t'; }, ' ');
  return ofText(bytes) == Kind::Unknown ? Kind::Unknown : Kind::Damaged;
}

bool isOwnFile(std::string_view path, const archive::File& file) {
  static constexpr std::string_view kEndings[] = {".sym", ".scn", ".vat", ".hmi", ".state", ".rec"};
  const std::string name = archive::folded(archive::nameOf(path));
  const bool named = std::ranges::any_of(kEndings, [&](std::string_view ending) {
    return name.size() > ending.size() && name.ends_with(ending);
  });
  const auto text = named ? decoded(file.text(kLooked)) : std::nullopt;
  return text && text->find('\0') == std::string::npos;
}

std::string_view extensionOf(Kind kind) {
  static constexpr std::pair<Kind, std::string_view> kExtensions[] = {
      {Kind::AwlSource, ".awl"},  {Kind::Listing, ".s5"}, {Kind::Sdf, ".sdf"},
      {Kind::Asc, ".asc"},        {Kind::Dif, ".dif"},    {Kind::Seq, ".seq"},
      {Kind::Assignments, ".seq"}};
  for (const auto& [table, extension] : kExtensions)
    if (table == kind) return extension;
  return {};
}

}  // namespace merker::importing
