#include "monitor/location.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "monitor/nowhere.h"
#include "monitor/symbol_name.h"

namespace merker::monitor {
namespace {

std::optional<std::uint32_t> number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Whether "plant.awl" names "examples/plant/plant.awl".
bool namesFile(std::string_view text, std::string_view file) {
  if (text == file) return true;
  return file.size() > text.size() && file.ends_with(text) &&
         file[file.size() - text.size() - 1] == '/';
}

// The first statement at or behind `line` in this block.
std::optional<CodeLine> lineAt(const BlockCode& block, std::uint32_t line) {
  std::optional<CodeLine> best;
  for (std::size_t i = 0; i < block.lineCount(); ++i) {
    const CodeLine one = block.line(i);
    if (one.line >= line && (!best || one.line < best->line)) best = one;
  }
  return best;
}

std::uint32_t lastLine(const BlockCode& block) {
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < block.lineCount(); ++i) last = std::max(last, block.line(i).line);
  return last;
}

// Strict: a line before or behind the block's statements is a mistake.
Result<SourcePlace> lineOfBlock(const BlockCode& block, std::uint32_t line) {
  const auto first = lineAt(block, 0), found = lineAt(block, line);
  if (!found || line < first->line)
    return makeProblem(ProblemCode::P1203, nowhere(), toString(block.id()), line,
                       first ? first->line : 0, lastLine(block));
  return sourcePlace(block, block.instructionAt(found->offset));
}

Result<SourcePlace> lineOfFile(std::string_view file, std::uint32_t line,
                               const ProgramCode& program) {
  std::optional<BlockCode> found;
  std::optional<CodeLine> nearest;
  bool known = false;
  for (const BlockCode& block : program.blocks()) {
    if (!namesFile(file, block.file())) continue;
    known = true;
    const auto one = lineAt(block, line);
    if (!one || (nearest && one->line >= nearest->line)) continue;
    found = block;
    nearest = one;
  }
  if (!known) return makeProblem(ProblemCode::P1202, nowhere(), std::string(file));
  if (!found) return makeProblem(ProblemCode::P1204, nowhere(), std::string(file), line);
  return sourcePlace(*found, found->instructionAt(nearest->offset));
}

Result<SourcePlace> network(const BlockCode& block, std::uint32_t wanted) {
  if (wanted == 0 || wanted > block.networkCount())
    return makeProblem(ProblemCode::P1205, nowhere(), toString(block.id()), block.networkCount(),
                       wanted);
  return sourcePlace(block, statementAt(block, block.networkBegin(wanted - 1)).begin);
}

Result<SourcePlace> atOffset(const BlockCode& block, std::uint32_t offset) {
  if (offset < block.length()) return sourcePlace(block, block.instructionAt(offset));
  const std::string id = toString(block.id());
  return makeProblem(ProblemCode::P1308, nowhere(),
                     fmt::format("{} {} {}", id, name(block.unit()), offset),
                     fmt::format("{} has {} {}s", id, block.length(), name(block.unit())));
}

// "network 2", "nw 2", "byte 6" or "word 6" behind a block.
Result<SourcePlace> inside(const BlockCode& block, std::string_view rest) {
  if (rest.empty()) return sourcePlace(block, block.lineCount() > 0 ? block.line(0).offset : 0);
  const std::size_t space = rest.find(' ');
  const std::string_view word = rest.substr(0, space);
  const auto value = number(trim(space == std::string_view::npos ? "" : rest.substr(space)));
  if (value && (equalsIgnoreCase(word, "network") || equalsIgnoreCase(word, "nw")))
    return network(block, *value);
  if (value && equalsIgnoreCase(word, name(block.unit()))) return atOffset(block, *value);
  return makeProblem(ProblemCode::P1201, nowhere(), std::string(rest));
}

// A block name at the beginning of `text`; `rest` gets what stands behind it.
std::string_view takeBlockName(std::string_view text, std::string_view& rest) {
  std::size_t end = 0;
  if (text.starts_with('"')) {
    end = std::min(text.find('"', 1), text.size() - 1) + 1;
  } else if (text.starts_with('-')) {
    end = std::min(text.find_first_of(": "), text.size());
  } else {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    while (end < text.size() && !isDigit(text[end]) && text[end] != ':') ++end;
    while (end < text.size() && isDigit(text[end])) ++end;
  }
  rest = trim(text.substr(end));
  return text.substr(0, end);
}

}  // namespace

Result<BlockId> findBlock(std::string_view text, const LocationContext& context) {
  text = trim(text);
  std::optional<BlockId> id = parseBlockId(text, context.program.kinds());
  const source::Symbol* symbol = writtenSymbol(text, context.symbols);
  if (symbol != nullptr && symbol->address.kind == source::SymbolAddress::Kind::Block)
    id = symbol->address.block;
  if (!id) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  if (!context.program.find(*id)) return makeProblem(ProblemCode::P1206, nowhere(), toString(*id));
  return *id;
}

Result<SourcePlace> findLocation(std::string_view text, const LocationContext& context) {
  text = trim(text);
  if (const auto line = number(text))
    return lineOfFile(context.currentFile, *line, context.program);
  std::string_view rest;
  const std::string_view name = takeBlockName(text, rest);
  const std::size_t colon = text.rfind(':');
  const bool isBlock = parseBlockId(trim(name), context.program.kinds()) || name.starts_with('"') ||
                       name.starts_with('-');
  if (!isBlock && colon != std::string_view::npos) {
    const auto line = number(trim(text.substr(colon + 1)));
    if (line) return lineOfFile(trim(text.substr(0, colon)), *line, context.program);
  }
  if (!isBlock) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  const auto id = findBlock(name, context);
  if (!id) return id.error();
  const BlockCode block = *context.program.find(*id);
  if (block.length() == 0) return makeProblem(ProblemCode::P1207, nowhere(), toString(*id));
  if (!rest.starts_with(':')) return inside(block, rest);
  const auto line = number(trim(rest.substr(1)));
  if (!line) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  return lineOfBlock(block, *line);
}

}  // namespace merker::monitor
