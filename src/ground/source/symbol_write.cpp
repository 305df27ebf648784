// Writers of the symbol formats; docs/formats/symbols.md shows each.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "source/dos_text.h"
#include "source/symbol_text.h"

namespace merker::source {
namespace {

// How operands are written.
struct Style {
  Mnemonics mnemonics;
  Language language;

  std::string_view operand(const SymbolAddress& address) const {
    return operandName(address, mnemonics, language);
  }
};

// Exactly `width` characters.
std::string column(std::string_view text, std::size_t width) {
  const std::size_t length = characterCount(text);
  std::string result(text);
  if (length < width) result.append(width - length, ' ');
  while (characterCount(result) > width) result.pop_back();
  return result;
}

// "A       1.0 ": four characters for the operand, five for the number, three for the bit.
std::string addressColumn(const SymbolAddress& address, const Style& style) {
  const std::string number = operandNumber(address);
  const std::size_t point = std::min(number.find('.'), number.size());
  return column(fmt::format("{:<4}{:>5}{}", style.operand(address), number.substr(0, point),
                            number.substr(point)),
                kAddressWidth);
}

std::string typeColumn(const Symbol& symbol) {
  const std::string type = typeText(symbol);
  if (symbol.type == TypeCode::TimeOfDay) return column("TOD", kTypeWidth);
  const std::size_t blank = type.find(' ');
  if (blank == std::string::npos) return column(type, kTypeWidth);
  return column(fmt::format("{:<4}{:>5}", type.substr(0, blank), type.substr(blank + 1)),
                kTypeWidth);
}

std::string plainAddress(const Symbol& symbol, const Style& style) {
  return fmt::format("{} {}", style.operand(symbol.address), operandNumber(symbol.address));
}

std::string withDoubledQuotes(std::string_view text) {
  std::string result;
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  return result;
}

std::string writeSdf(const SymbolTable& table, const Style& style) {
  std::string text;
  for (const Symbol& s : table.list())
    text += fmt::format("\"{}\",\"{}\",\"{}\",\"{}\"\r\n", column(s.name, kNameWidth),
                        addressColumn(s.address, style), typeColumn(s),
                        withDoubledQuotes(column(s.comment, kCommentWidth)));
  return text;
}

std::string writeAsc(const SymbolTable& table, const Style& style) {
  constexpr std::size_t kLength = kNameWidth + kAddressWidth + kTypeWidth + kCommentWidth;
  std::string text;
  for (const Symbol& s : table.list())
    text += fmt::format("{},{}{}{}{}\r\n", kLength, column(s.name, kNameWidth),
                        addressColumn(s.address, style), typeColumn(s),
                        column(s.comment, kCommentWidth));
  return text;
}

std::string writeSeq(const SymbolTable& table, const Style& style) {
  std::string text;
  for (const Symbol& s : table.list())
    text += fmt::format("\t{}\t{}\t{}\r\n", plainAddress(s, style), s.name, s.comment);
  return text;
}

std::string writeDif(const SymbolTable& table, const Style& style) {
  std::string text = fmt::format(
      "TABLE\r\n0,1\r\n\"Merker\"\r\nVECTORS\r\n0,{}\r\n\"\"\r\nTUPLES\r\n0,4\r\n\"\"\r\nDATA\r\n0,"
      "0\r\n\"\"\r\n",
      table.list().size());
  for (const Symbol& s : table.list()) {
    text += "-1,0\r\nBOT\r\n";
    for (const std::string& field : {s.name, plainAddress(s, style), typeText(s), s.comment})
      text += fmt::format("1,0\r\n\"{}\"\r\n", field);
  }
  return text + "-1,0\r\nEOD\r\n";
}

std::string writeSym(const SymbolTable& table, const Style& style) {
  std::size_t widest = 0;
  for (const Symbol& s : table.list()) widest = std::max(widest, characterCount(s.name));
  std::string text;
  for (const Symbol& s : table.list()) {
    const std::string type = typeText(s);
    const std::string comment = s.comment.empty() ? "" : "// " + s.comment;
    text += fmt::format("{}  {}{}{}\n", column('"' + s.name + '"', widest + 2),
                        column(plainAddress(s, style), kAddressWidth),
                        comment.empty() ? type : column(type, kTypeWidth + 2), comment);
  }
  return text;
}

}  // namespace

std::string symbolText(const SymbolTable& table, std::string_view extension, Mnemonics mnemonics) {
  static constexpr std::pair<std::string_view, std::string (*)(const SymbolTable&, const Style&)>
      kWriters[] = {{".sdf", writeSdf},
                    {".asc", writeAsc},
                    {".seq", writeSeq},
                    {".dif", writeDif},
                    {".sym", writeSym}};
  for (const auto& [name, write] : kWriters)
    if (extension == name) return write(table, {mnemonics, table.language()});
  return {};
}

std::string writeSymbols(const SymbolTable& table, std::string_view extension,
                         Mnemonics mnemonics) {
  const std::string text = symbolText(table, extension, mnemonics);
  if (extension == ".sym") return text;
  // STEP 5 is a program of DOS.
  const bool dos = extension == ".seq" && table.language() == Language::Step5;
  return dos ? toDos(text, Encoding::Cp437) : toCp1252(text);
}

}  // namespace merker::source
