#include "s5project/symbols.h"

#include <fmt/format.h>

#include "source/symbol_text.h"

namespace merker::s5project {
namespace {

constexpr std::size_t kMostNotes = 50;
constexpr const char* kName = "Z0.SEQ";

// The list is in the code page of the program beside it, unless an editor saved it as Unicode.
Encoding encodingOf(const std::string& bytes, Encoding codePage) {
  const Encoding guess = detectEncoding(bytes);
  const bool onePage =
      guess == Encoding::Cp1252 || guess == Encoding::Cp437 || guess == Encoding::Cp850;
  return onePage ? codePage : guess;
}

bool isValid(const source::Symbol& symbol) {
  return characterCount(symbol.name) <= source::kNameWidth &&
         symbol.name.find('"') == std::string::npos;
}

// At most as many characters as a project takes.
std::string shortened(const std::string& comment) {
  std::size_t end = 0;
  for (std::size_t characters = 0; end < comment.size(); ++end) {
    const bool begins = (static_cast<unsigned char>(comment[end]) & 0xC0) != 0x80;
    if (begins && ++characters > source::kCommentWidth) break;
  }
  return comment.substr(0, end);
}

}  // namespace

Symbols readAssignments(const std::string& bytes, Encoding codePage) {
  Symbols result;
  const Encoding encoding = encodingOf(bytes, codePage);
  if (encoding == Encoding::Binary) {
    result.notes.push_back(fmt::format("{}: this is not text", kName));
    return result;
  }
  source::SymbolTable all(source::Language::Step5);
  Problems problems;
  source::readSymbols(source::SourceFile(kName, toUtf8(bytes, encoding)), all, problems);
  for (const Problem& problem : problems.list())
    if (result.notes.size() < kMostNotes)
      result.notes.push_back(
          fmt::format("{}, line {}: {}", kName, problem.position.line, problem.message));
  if (problems.list().size() > kMostNotes)
    result.notes.push_back(
        fmt::format("{}: {} more lines like these", kName, problems.list().size() - kMostNotes));
  for (source::Symbol symbol : all.list()) {
    if (!isValid(symbol)) continue;
    symbol.comment = shortened(symbol.comment);
    result.table.add(std::move(symbol));
  }
  if (!result.table.list().empty())
    result.text = source::writeSymbols(result.table, ".sym", Mnemonics::German);
  return result;
}

}  // namespace merker::s5project
