#include "monitor/code.h"

#include <charconv>

#include "base/text.h"
#include "monitor/step5_code.h"
#include "monitor/step7_code.h"

namespace merker::monitor {

std::string_view name(CodeUnit unit) { return unit == CodeUnit::Word ? "word" : "byte"; }

BlockId BlockCode::id() const {
  return std::visit([](const auto* block) { return blockId(*block); }, block_);
}

const std::string& BlockCode::file() const {
  return std::visit([](const auto* block) -> const std::string& { return block->file; }, block_);
}

CodeUnit BlockCode::unit() const {
  return std::holds_alternative<const mc5::Block*>(block_) ? CodeUnit::Word : CodeUnit::Byte;
}

std::uint32_t BlockCode::length() const {
  return std::visit([](const auto* block) { return codeLength(*block); }, block_);
}

std::size_t BlockCode::lineCount() const {
  if (length() == 0) return 0;  // the lines of a data block are values
  return std::visit([](const auto* block) { return block->lines.size(); }, block_);
}

CodeLine BlockCode::line(std::size_t index) const {
  return std::visit(
      [index](const auto* block) {
        const auto& entry = block->lines[index];
        return CodeLine{entry.offset, entry.line, entry.column};
      },
      block_);
}

std::size_t BlockCode::networkCount() const {
  return std::visit(
      [](const auto* block) { return block->networks.size() + unnamedNetworks(*block); }, block_);
}

std::uint32_t BlockCode::networkBegin(std::size_t index) const {
  return std::visit(
      [index](const auto* block) -> std::uint32_t {
        const std::size_t unnamed = unnamedNetworks(*block);
        return index < unnamed ? 0 : block->networks[index - unnamed].offset;
      },
      block_);
}

std::uint32_t BlockCode::instructionAt(std::uint32_t offset) const {
  return std::visit([offset](const auto* block) { return instructionStart(*block, offset); },
                    block_);
}

std::uint32_t BlockCode::processedAt(std::uint32_t offset) const {
  return std::visit([offset](const auto* block) { return processedInstruction(*block, offset); },
                    block_);
}

CodeUnit ProgramCode::unit() const {
  return std::holds_alternative<const mc5::Program*>(program_) ? CodeUnit::Word : CodeUnit::Byte;
}

std::span<const BlockKind> ProgramCode::kinds() const {
  return std::visit([](const auto* program) { return blockKinds(*program); }, program_);
}

std::vector<BlockCode> ProgramCode::blocks() const {
  return std::visit(
      [](const auto* program) {
        std::vector<BlockCode> list;
        for (const auto& [id, block] : *program) list.emplace_back(block);
        return list;
      },
      program_);
}

std::optional<BlockCode> ProgramCode::find(BlockId id) const {
  return std::visit(
      [id](const auto* program) -> std::optional<BlockCode> {
        const auto* block = findBlock(*program, id);
        return block == nullptr ? std::nullopt : std::optional<BlockCode>(*block);
      },
      program_);
}

std::optional<BlockId> parseBlockId(std::string_view text, std::span<const BlockKind> kinds) {
  for (const BlockKind kind : kinds) {
    const std::string_view word = merker::name(kind);
    if (!equalsIgnoreCase(text.substr(0, word.size()), word)) continue;
    const std::string_view digits = trim(text.substr(word.size()));
    std::uint16_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (!digits.empty() && error == std::errc{} && end == digits.data() + digits.size())
      return BlockId{kind, number};
  }
  return std::nullopt;
}

}  // namespace merker::monitor
