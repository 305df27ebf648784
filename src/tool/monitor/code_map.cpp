#include "monitor/code_map.h"

#include <fmt/format.h>

#include <algorithm>

namespace merker::monitor {

Statement statementAt(const block::Block& block, std::uint32_t offset) {
  const auto& lines = block.lines;
  const auto size = static_cast<std::uint32_t>(block.code.size());
  const auto next = std::upper_bound(
      lines.begin(), lines.end(), offset,
      [](std::uint32_t value, const block::LineEntry& entry) { return value < entry.offset; });
  if (next == lines.begin()) return {0, lines.empty() ? size : lines.front().offset, 0, 0};
  const block::LineEntry& entry = *(next - 1);
  return {entry.offset, next == lines.end() ? size : next->offset, entry.line, entry.column};
}

bool beginsStatement(const block::Block& block, std::uint32_t offset) {
  if (block.lines.empty()) return true;
  const Statement statement = statementAt(block, offset);
  return statement.line != 0 && statement.begin == offset;
}

bool endsBlock(const block::Block& block, std::uint32_t offset) {
  constexpr std::size_t kLength = 2;  // bytes of BE
  return offset + kLength == block.code.size() && !beginsStatement(block, offset);
}

std::uint32_t networkAt(const block::Block& block, std::uint32_t offset) {
  const auto behind =
      std::upper_bound(block.networks.begin(), block.networks.end(), offset,
                       [](std::uint32_t value, const auto& row) { return value < row.offset; });
  return static_cast<std::uint32_t>(behind - block.networks.begin());
}

SourcePlace sourcePlace(const block::Block& block, std::uint32_t offset) {
  return {.block = block.id,
          .offset = offset,
          .file = block.file,
          .line = block.line(offset),
          .network = networkAt(block, offset)};
}

SourcePlace sourcePlace(const block::Program& program, BlockId id, std::uint32_t offset) {
  const auto found = program.find(id);
  if (found != program.end()) return sourcePlace(found->second, offset);
  SourcePlace place;
  place.block = id;
  place.offset = offset;
  return place;
}

std::string toString(const SourcePlace& place) {
  std::string text = fmt::format("{} byte {}", toString(place.block), place.offset);
  if (place.line != 0) text += fmt::format(" ({}:{})", place.file, place.line);
  return text;
}

}  // namespace merker::monitor
