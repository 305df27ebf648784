#include "monitor/code_map.h"

#include <fmt/format.h>

namespace merker::monitor {
namespace {

// Of `count` ascending offsets, how many are not behind `offset`.
template <typename OffsetOf>
std::size_t countUpTo(std::size_t count, std::uint32_t offset, OffsetOf offsetOf) {
  std::size_t first = 0;
  while (first < count) {
    const std::size_t middle = first + (count - first) / 2;
    if (offsetOf(middle) <= offset)
      first = middle + 1;
    else
      count = middle;
  }
  return first;
}

// How many lines begin at or in front of `offset`.
std::size_t linesUpTo(const BlockCode& block, std::uint32_t offset) {
  const auto offsetOf = [&](std::size_t i) { return block.line(i).offset; };
  return countUpTo(block.lineCount(), offset, offsetOf);
}

}  // namespace

Statement statementAt(const BlockCode& block, std::uint32_t offset) {
  const std::size_t count = block.lineCount(), next = linesUpTo(block, offset);
  const std::uint32_t end = next == count ? block.length() : block.line(next).offset;
  if (next == 0) return {0, end, 0, 0};
  const CodeLine line = block.line(next - 1);
  return {line.offset, end, line.line, line.column};
}

bool beginsStatement(const BlockCode& block, std::uint32_t offset) {
  if (block.lineCount() == 0) return true;
  const Statement statement = statementAt(block, offset);
  return statement.line != 0 && statement.begin == offset;
}

bool endsBlock(const BlockCode& block, std::uint32_t offset) {
  const std::uint32_t length = block.unit() == CodeUnit::Word ? 1 : 2;  // of BE
  return offset + length == block.length() && !beginsStatement(block, offset);
}

std::uint32_t networkAt(const BlockCode& block, std::uint32_t offset) {
  const auto offsetOf = [&](std::size_t i) { return block.networkBegin(i); };
  return static_cast<std::uint32_t>(countUpTo(block.networkCount(), offset, offsetOf));
}

std::uint32_t statementNumber(const BlockCode& block, std::uint32_t offset) {
  const std::uint32_t network = networkAt(block, offset);
  const std::uint32_t begin = network == 0 ? 0 : block.networkBegin(network - 1);
  const std::size_t before = begin == 0 ? 0 : linesUpTo(block, begin - 1);
  return static_cast<std::uint32_t>(linesUpTo(block, offset) - before);
}

SourcePlace sourcePlace(const BlockCode& block, std::uint32_t offset) {
  return {.block = block.id(),
          .offset = offset,
          .file = block.file(),
          .line = statementAt(block, offset).line,
          .network = networkAt(block, offset),
          .unit = block.unit()};
}

SourcePlace sourcePlace(const ProgramCode& program, BlockId id, std::uint32_t offset) {
  if (const auto block = program.find(id)) return sourcePlace(*block, offset);
  SourcePlace place;
  place.block = id;
  place.offset = offset;
  place.unit = program.unit();
  return place;
}

std::string toString(const SourcePlace& place) {
  std::string text = fmt::format("{} {} {}", toString(place.block), name(place.unit), place.offset);
  if (place.line != 0) text += fmt::format(" ({}:{})", place.file, place.line);
  return text;
}

}  // namespace merker::monitor
