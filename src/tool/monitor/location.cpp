#include "monitor/location.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text.h"
#include "mc7/disassembly.h"

namespace merker::monitor {
namespace {

Position nowhere() { return Position{"", 0, 0, 0}; }

std::optional<std::uint32_t> number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<BlockId> blockId(std::string_view text) {
  constexpr BlockKind kKinds[] = {BlockKind::OB, BlockKind::FC, BlockKind::FB, BlockKind::DB};
  if (text.size() < 3) return std::nullopt;
  for (const BlockKind kind : kKinds) {
    if (!equalsIgnoreCase(text.substr(0, 2), name(kind))) continue;
    const auto value = number(trim(text.substr(2)));
    if (value && *value <= 0xFFFF) return BlockId{kind, static_cast<std::uint16_t>(*value)};
  }
  return std::nullopt;
}

// Whether "plant.awl" names "examples/plant/plant.awl".
bool namesFile(std::string_view text, std::string_view file) {
  if (text == file) return true;
  return file.size() > text.size() && file.ends_with(text) &&
         file[file.size() - text.size() - 1] == '/';
}

// The first statement at or behind `line` in this block.
const block::LineEntry* entryAt(const block::Block& block, std::uint32_t line) {
  const block::LineEntry* best = nullptr;
  for (const block::LineEntry& entry : block.lines)
    if (entry.line >= line && (best == nullptr || entry.line < best->line)) best = &entry;
  return best;
}

// Strict: a line before or behind the block's statements is a mistake.
Result<SourcePlace> lineOfBlock(const block::Block& block, std::uint32_t line) {
  const auto [first, last] = std::minmax_element(
      block.lines.begin(), block.lines.end(),
      [](const block::LineEntry& a, const block::LineEntry& b) { return a.line < b.line; });
  if (first == block.lines.end() || line < first->line || line > last->line)
    return makeProblem(ProblemCode::P1203, nowhere(), toString(block.id), line,
                       first == block.lines.end() ? 0 : first->line,
                       last == block.lines.end() ? 0 : last->line);
  return sourcePlace(block, entryAt(block, line)->offset);
}

Result<SourcePlace> lineOfFile(std::string_view file, std::uint32_t line,
                               const block::Program& program) {
  const block::Block* found = nullptr;
  const block::LineEntry* nearest = nullptr;
  bool known = false;
  for (const auto& [id, block] : program) {
    if (!namesFile(file, block.file)) continue;
    known = true;
    const block::LineEntry* entry = entryAt(block, line);
    if (entry == nullptr || (nearest != nullptr && entry->line >= nearest->line)) continue;
    found = &block;
    nearest = entry;
  }
  if (!known) return makeProblem(ProblemCode::P1202, nowhere(), std::string(file));
  if (found == nullptr) return makeProblem(ProblemCode::P1204, nowhere(), std::string(file), line);
  return sourcePlace(*found, nearest->offset);
}

Result<SourcePlace> network(const block::Block& block, std::uint32_t wanted) {
  if (wanted == 0 || wanted > block.networks.size())
    return makeProblem(ProblemCode::P1205, nowhere(), toString(block.id), block.networks.size(),
                       wanted);
  return sourcePlace(block, statementAt(block, block.networks[wanted - 1].offset).begin);
}

// A byte inside an instruction, or in the list behind a call, stands for the instruction.
std::uint32_t instructionAt(const block::Block& block, std::uint32_t byte) {
  std::uint32_t at = 0;
  for (const mc7::Line& line : mc7::disassemble(block.code, Mnemonics::German))
    if (line.kind == mc7::LineKind::Instruction && line.offset <= byte) at = line.offset;
  return at;
}

// "network 2", "nw 2", "byte 6" behind a block.
Result<SourcePlace> inside(const block::Block& block, std::string_view rest) {
  if (rest.empty()) {
    const bool lines = !block.lines.empty();
    return sourcePlace(block, lines ? block.lines.front().offset : 0);
  }
  const std::size_t space = rest.find(' ');
  const std::string_view word = rest.substr(0, space);
  const auto value = number(trim(space == std::string_view::npos ? "" : rest.substr(space)));
  if (value && (equalsIgnoreCase(word, "network") || equalsIgnoreCase(word, "nw")))
    return network(block, *value);
  if (value && equalsIgnoreCase(word, "byte") && *value < block.code.size())
    return sourcePlace(block, instructionAt(block, *value));
  return makeProblem(ProblemCode::P1201, nowhere(), std::string(rest));
}

// A block name at the beginning of `text`; `rest` gets what stands behind it.
std::string_view takeBlockName(std::string_view text, std::string_view& rest) {
  std::size_t end = 0;
  if (text.starts_with('"')) {
    end = std::min(text.find('"', 1), text.size() - 1) + 1;
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
  std::optional<BlockId> id = blockId(text);
  if (text.size() > 2 && text.front() == '"' && text.back() == '"') {
    const source::Symbol* symbol = context.symbols.find(text.substr(1, text.size() - 2));
    if (symbol != nullptr && symbol->address.kind == source::SymbolAddress::Kind::Block)
      id = symbol->address.block;
  }
  if (!id) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  if (!context.program.contains(*id))
    return makeProblem(ProblemCode::P1206, nowhere(), toString(*id));
  return *id;
}

Result<SourcePlace> findLocation(std::string_view text, const LocationContext& context) {
  text = trim(text);
  if (const auto line = number(text))
    return lineOfFile(context.currentFile, *line, context.program);
  std::string_view rest;
  const std::string_view name = takeBlockName(text, rest);
  const std::size_t colon = text.rfind(':');
  const bool isBlock = blockId(trim(name)) || name.starts_with('"');
  if (!isBlock && colon != std::string_view::npos) {
    const auto line = number(trim(text.substr(colon + 1)));
    if (line) return lineOfFile(trim(text.substr(0, colon)), *line, context.program);
  }
  if (!isBlock) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  const auto id = findBlock(name, context);
  if (!id) return id.error();
  const block::Block& block = context.program.at(*id);
  if (block.code.empty()) return makeProblem(ProblemCode::P1207, nowhere(), toString(*id));
  if (!rest.starts_with(':')) return inside(block, rest);
  const auto line = number(trim(rest.substr(1)));
  if (!line) return makeProblem(ProblemCode::P1201, nowhere(), std::string(text));
  return lineOfBlock(block, *line);
}

}  // namespace merker::monitor
