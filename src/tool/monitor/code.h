// Code of a program as places in it are named: statements, lines and networks of a block of either
// family. Both classes refer to the blocks, which must outlive them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "block/block.h"
#include "mc5/block.h"

namespace merker::monitor {

// What offsets count: bytes of MC7, words of MC5.
enum class CodeUnit : std::uint8_t { Byte, Word };
std::string_view name(CodeUnit unit);  // "byte"

// From where on the code was made of this statement of the source.
struct CodeLine {
  std::uint32_t offset = 0, line = 0, column = 0;
};

class BlockCode {
 public:
  BlockCode(const block::Block& block) : block_(&block) {}  // of a SIMATIC S7
  BlockCode(const mc5::Block& block) : block_(&block) {}    // of a SINUMERIK

  BlockId id() const;
  const std::string& file() const;
  CodeUnit unit() const;
  std::uint32_t length() const;  // in its unit; 0: a data block
  // One for each statement, ascending by offset; none without a source.
  std::size_t lineCount() const;
  CodeLine line(std::size_t index) const;
  // Without a network line a block of STEP 5 is one network, a block of STEP 7 has none.
  std::size_t networkCount() const;
  std::uint32_t networkBegin(std::size_t index) const;
  // Where the instruction begins that contains this byte or word; the list behind a call is part
  // of the call, and what B of STEP 5 processes is part of B.
  std::uint32_t instructionAt(std::uint32_t offset) const;
  // The instruction that the one at `offset` processes: behind B the next one, else itself.
  std::uint32_t processedAt(std::uint32_t offset) const;
  // The block itself; null: it is of the other family.
  const block::Block* s7() const { return get<const block::Block*>(); }
  const mc5::Block* s5() const { return get<const mc5::Block*>(); }

 private:
  template <typename Block>
  Block get() const {
    const Block* one = std::get_if<Block>(&block_);
    return one == nullptr ? nullptr : *one;
  }
  std::variant<const block::Block*, const mc5::Block*> block_;
};

class ProgramCode {
 public:
  ProgramCode(const block::Program& program) : program_(&program) {}
  ProgramCode(const mc5::Program& program) : program_(&program) {}

  CodeUnit unit() const;
  std::span<const BlockKind> kinds() const;  // that a program of this family has
  std::vector<BlockCode> blocks() const;
  std::optional<BlockCode> find(BlockId id) const;
  // visitor(const block::Program&) or visitor(const mc5::Program&)
  template <typename Visitor>
  auto visit(Visitor&& visitor) const {
    return std::visit([&visitor](const auto* program) { return visitor(*program); }, program_);
  }

 private:
  std::variant<const block::Program*, const mc5::Program*> program_;
};

// "FC 1", "fc1", of one of these kinds.
std::optional<BlockId> parseBlockId(std::string_view text, std::span<const BlockKind> kinds);

}  // namespace merker::monitor
