// Readers of the symbol formats; docs/formats/symbols.md shows each.
#include <algorithm>
#include <array>
#include <vector>

#include "base/text.h"
#include "source/symbol_text.h"

namespace merker::source {
namespace {

struct Target {
  const SourceFile& file;
  SymbolTable& table;
  Problems& problems;

  void add(const SymbolLine& line) const { add(line, std::string(line.comment)); }
  void add(const SymbolLine& line, std::string comment) const {
    addSymbol(line, std::move(comment), table, problems);
  }
  void refuse(const SymbolLine& line, std::string_view format, std::string_view example) const {
    problems.add(ProblemCode::P0810, line.at({}), format, example);
  }
};

// Calls `read` with each line that is not blank.
template <typename Read>
void eachLine(const SourceFile& file, const Problems& problems, Read read) {
  for (std::uint32_t i = 1; i <= file.lineCount() && !problems.cancelled(); ++i) {
    SymbolLine line;
    line.file = &file;
    line.line = file.line(i);
    if (!trim(line.line).empty()) read(line);
  }
}

// The first `count` characters, taken away from `text`.
std::string_view takeColumn(std::string_view& text, std::size_t count) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < count && bytes < text.size(); ++i) {
    ++bytes;
    while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) ++bytes;
  }
  const std::string_view result = text.substr(0, bytes);
  text.remove_prefix(bytes);
  return result;
}

// --- .asc: "126," and four columns ---

void readColumns(SymbolLine& line, const Target& target) {
  const std::size_t comma = line.line.find(',');
  const std::string_view prefix = trim(line.line.substr(0, comma));
  if (comma == std::string_view::npos ||
      prefix.find_first_not_of("0123456789") != std::string_view::npos)
    return target.refuse(line, ".asc", "126,Motor                   A       1.0 BOOL");
  std::string_view rest = line.line.substr(comma + 1);
  line.name = trim(takeColumn(rest, kNameWidth));
  line.address = trim(takeColumn(rest, kAddressWidth));
  line.type = trim(takeColumn(rest, kTypeWidth));
  line.comment = trim(rest);
  target.add(line);
}

// --- .sdf: four fields in quotation marks ---

// Whether the quotation mark at `i` ends its field: a comma or the end of the line follows.
bool endsField(std::string_view text, std::size_t i) {
  const std::size_t next = text.find_first_not_of(" \t\r", i + 1);
  return next == std::string_view::npos || text[next] == ',';
}

// The next field, taken away from `text` with the comma behind it.
std::string_view takeField(std::string_view& text) {
  text = trim(text);
  std::size_t end = 0;
  std::string_view field;
  if (text.starts_with('"')) {
    end = 1;
    while (end < text.size() && !(text[end] == '"' && endsField(text, end)))
      end += text[end] == '"' && end + 1 < text.size() && text[end + 1] == '"' ? 2 : 1;
    end = std::min(end, text.size());
    field = text.substr(1, end - 1);
  }
  end = std::min(text.find(',', end), text.size());
  if (!text.starts_with('"')) field = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return trim(field);
}

std::string withoutDoubledQuotes(std::string_view field) {
  std::string result;
  for (std::size_t i = 0; i < field.size(); ++i) {
    result += field[i];
    if (field[i] == '"' && i + 1 < field.size() && field[i + 1] == '"') ++i;
  }
  return result;
}

void readFields(SymbolLine& line, const Target& target) {
  std::string_view rest = line.line;
  line.name = takeField(rest);
  line.address = takeField(rest);
  line.type = takeField(rest);
  line.comment = takeField(rest);
  if (line.address.empty() || !trim(rest).empty())
    return target.refuse(line, ".sdf", R"("Motor","A 1.0","BOOL","comment")");
  target.add(line, withoutDoubledQuotes(line.comment));
}

// --- words ---

// The front of `text` up to a blank, taken away.
std::string_view takeWord(std::string_view& text) {
  text = trim(text);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end);
  return word;
}

// "A 1.0", "MW10", "DB  5": letters, perhaps blanks, a number.
std::string_view takeOperand(std::string_view& text) {
  text = trim(text);
  const std::string_view whole = text;
  if (takeWord(text).find_first_of("0123456789") == std::string_view::npos) takeWord(text);
  return whole.substr(0, whole.size() - text.size());
}

// --- .seq: address, symbol, comment behind tabs ---

// A field up to the next tab, taken away.
std::string_view takeTabbed(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\t'), rest.size());
  const std::string_view field = trim(rest.substr(0, end));
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return field;
}

// STEP 5 may have a mark in front of the first tab.
bool isMark(std::string_view field, Language language) {
  return language == Language::Step5 && !parseSymbolAddress(field, {}, language);
}

void splitAtTabs(SymbolLine& line, Language language) {
  std::string_view rest = line.line;
  if (rest.starts_with('\t') || isMark(rest.substr(0, rest.find('\t')), language)) takeTabbed(rest);
  line.address = takeTabbed(rest);
  line.name = takeTabbed(rest);
  line.comment = trim(rest);
}

// Columns filled with blanks: how wide they are differs, so the words count.
void splitAtBlanks(SymbolLine& line) {
  std::string_view rest = line.line;
  line.address = takeOperand(rest);
  line.name = takeWord(rest);
  line.comment = trim(rest);
}

void readAssignment(SymbolLine& line, const Target& target) {
  const Language language = target.table.language();
  const bool step5 = language == Language::Step5;
  if (step5 && trim(line.line).starts_with(';')) return;
  if (step5 && line.line.find('\t') == std::string_view::npos)
    splitAtBlanks(line);
  else
    splitAtTabs(line, language);
  // An operand with a comment alone, or a comment.
  if (step5 && (line.address.empty() || line.name.empty())) return;
  if (line.address.empty() || line.name.empty())
    return target.refuse(line, ".seq", "(tab)A 1.0(tab)Motor(tab)comment");
  target.add(line);
}

// --- .sym: "name" operand type // comment ---

std::string_view takeName(std::string_view& text) {
  if (!text.starts_with('"')) return takeWord(text);
  const std::size_t end = std::min(text.find('"', 1), text.size());
  const std::string_view name = text.substr(1, end - 1);
  text.remove_prefix(std::min(end + 1, text.size()));
  return trim(name);
}

void readTableLine(SymbolLine& line, const Target& target) {
  std::string_view rest = trim(line.line);
  if (rest.starts_with("//")) return;
  line.name = takeName(rest);
  const std::size_t comment = std::min(rest.find("//"), rest.size());
  if (comment < rest.size()) line.comment = trim(rest.substr(comment + 2));
  rest = rest.substr(0, comment);
  line.address = takeOperand(rest);
  line.type = trim(rest);
  if (line.address.empty())
    return target.refuse(line, ".sym", R"("Motor"  A 1.0  BOOL  // comment)");
  target.add(line);
}

// --- .dif: pairs of lines ---

std::string_view unquoted(std::string_view text) {
  text = trim(text);
  if (text.starts_with('"')) text.remove_prefix(1);
  if (text.ends_with('"')) text.remove_suffix(1);
  return trim(text);
}

void addTuple(SymbolLine& line, std::vector<std::string_view>& fields, const Target& target) {
  if (fields.empty()) return;
  fields.resize(4);
  line.name = fields[0];
  line.address = fields[1];
  line.type = fields[2];
  line.comment = fields[3];
  target.add(line);
  fields.clear();
}

// The number of the first line of the body, 0 if there is no DATA header.
std::uint32_t bodyOf(const SourceFile& file) {
  for (std::uint32_t i = 1; i <= file.lineCount(); ++i)
    if (equalsIgnoreCase(trim(file.line(i)), "DATA")) return i + 3;
  return 0;
}

void readDif(const Target& target) {
  const SourceFile& file = target.file;
  SymbolLine line;
  line.file = &file;
  line.line = file.line(1);
  std::vector<std::string_view> fields;
  const std::uint32_t body = bodyOf(file);
  for (std::uint32_t i = body; body != 0 && i <= file.lineCount() && !target.problems.cancelled();
       i += 2) {
    const std::string_view kind = trim(file.line(i)), value = file.line(i + 1);
    if (kind.empty()) {  // Excel sets blank lines between the pairs
      --i;
      continue;
    }
    if (kind.starts_with("0,") || kind.starts_with("1,")) {
      fields.push_back(unquoted(value));
      continue;
    }
    if (kind.starts_with("-1")) addTuple(line, fields, target);
    line.line = file.line(i);
    if (!kind.starts_with("-1")) break;
    if (equalsIgnoreCase(trim(value), "EOD")) return;
  }
  target.refuse(line, ".dif", "TABLE … DATA, then BOT and four texts per symbol, at the end EOD");
}

template <void (*read)(SymbolLine&, const Target&)>
void readLines(const Target& target) {
  eachLine(target.file, target.problems, [&](SymbolLine& line) { read(line, target); });
}

struct Format {
  std::string_view extension;
  void (*read)(const Target&);
};
constexpr std::array kFormats{
    Format{".sdf", readLines<readFields>},     Format{".asc", readLines<readColumns>},
    Format{".seq", readLines<readAssignment>}, Format{".dif", readDif},
    Format{".sym", readLines<readTableLine>},  Format{".txt", readLines<readTableLine>},
};

}  // namespace

std::string extensionOf(std::string_view path) {
  const std::size_t point = path.find_last_of("./\\");
  if (point == std::string_view::npos || path[point] != '.') return {};
  std::string extension(path.substr(point));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

void readSymbols(const SourceFile& file, SymbolTable& table, Problems& problems) {
  const std::string extension = extensionOf(file.name());
  for (const Format& format : kFormats)
    if (format.extension == extension) return format.read({file, table, problems});
  problems.add(ProblemCode::P0811, Position{file.name()}, extension);
}

bool isSymbolFile(std::string_view path) {
  const std::string extension = extensionOf(path);
  return extension != ".txt" && std::any_of(kFormats.begin(), kFormats.end(), [&](const Format& f) {
           return f.extension == extension;
         });
}

}  // namespace merker::source
