#include "workbench/block_sources.h"

#include <charconv>
#include <optional>

#include "base/text.h"
#include "mc5/block_id.h"
#include "step5/block_source.h"

namespace merker::workbench {
namespace {

struct Keyword {
  std::string_view begin, end;
};
constexpr Keyword kKeywords[] = {{"ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK"},
                                 {"FUNCTION_BLOCK", "END_FUNCTION_BLOCK"},
                                 {"FUNCTION", "END_FUNCTION"},
                                 {"DATA_BLOCK", "END_DATA_BLOCK"},
                                 {"TYPE", "END_TYPE"}};
constexpr BlockKind kKinds[] = {BlockKind::OB, BlockKind::FC, BlockKind::FB, BlockKind::DB,
                                BlockKind::UDT};

bool beginsWith(std::string_view line, std::string_view word) {
  const std::string_view text = trim(line);
  return text.size() >= word.size() && equalsIgnoreCase(text.substr(0, word.size()), word) &&
         (text.size() == word.size() || text[word.size()] == ' ' || text[word.size()] == '\t' ||
          text[word.size()] == '"' || text[word.size()] == ';');
}

const Keyword* keywordOf(std::string_view line) {
  for (const Keyword& keyword : kKeywords)
    if (beginsWith(line, keyword.begin)) return &keyword;
  return nullptr;
}

// "FC 1 : VOID", "\"Motor\"".
std::optional<BlockId> idOf(std::string_view text, const source::SymbolTable& symbols) {
  text = trim(text);
  if (text.starts_with('"')) {
    const source::Symbol* symbol = symbols.find(text.substr(1, text.find('"', 1) - 1));
    const bool block =
        symbol != nullptr && symbol->address.kind == source::SymbolAddress::Kind::Block;
    return block ? std::optional(symbol->address.block) : std::nullopt;
  }
  for (const BlockKind kind : kKinds) {
    const std::string_view word = name(kind);
    if (text.size() <= word.size() || !equalsIgnoreCase(text.substr(0, word.size()), word))
      continue;
    const std::string_view digits = trim(text.substr(word.size()));
    std::uint16_t number = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (result.ec == std::errc{}) return BlockId{kind, number};
  }
  return std::nullopt;
}

}  // namespace

std::map<BlockId, BlockSource> blockSources(const std::vector<source::SourceFile>& sources,
                                            const source::SymbolTable& symbols) {
  std::map<BlockId, BlockSource> found;
  for (const source::SourceFile& file : sources) {
    const Keyword* open = nullptr;
    std::optional<BlockId> id;
    BlockSource block;
    for (std::uint32_t line = 1; line <= file.lineCount(); ++line) {
      const std::string_view text = file.line(line);
      if (open == nullptr && (open = keywordOf(text)) != nullptr) {
        id = idOf(trim(text).substr(open->begin.size()), symbols);
        block = {file.name(), line, {}};
      }
      if (open == nullptr) continue;
      block.text.append(text).append("\n");
      if (!beginsWith(text, open->end)) continue;
      if (id) found.emplace(*id, std::move(block));
      open = nullptr;
    }
  }
  return found;
}

std::map<BlockId, BlockSource> listingSources(const std::vector<source::SourceFile>& listings) {
  std::map<BlockId, BlockSource> found;
  Problems ignored;  // program.check tells them
  for (const source::SourceFile& file : listings)
    for (const step5::BlockSource& one : step5::findBlocks(file, ignored)) {
      const std::uint32_t head = file.position(one.offset, one.length).line;
      BlockSource block{file.name(), head, std::string(file.line(head)).append("\n")};
      for (const step5::Line& line : one.lines) block.text.append(line.text).append("\n");
      found.emplace(mc5::neutralId(one.id), std::move(block));
    }
  return found;
}

}  // namespace merker::workbench
