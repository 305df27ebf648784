#include "softplc/segments.h"

#include <array>

namespace merker::sinumerik {
namespace {

using mc5::BlockType;

constexpr std::uint32_t kProgram = 5, kData = 6;

std::uint8_t byteOf(std::uint16_t word, std::uint32_t offset) {
  return static_cast<std::uint8_t>(offset % 2 == 0 ? word >> 8 : word);
}

std::uint16_t withByte(std::uint16_t word, std::uint32_t offset, std::uint8_t value) {
  return static_cast<std::uint16_t>(offset % 2 == 0 ? value << 8 | (word & 0xFF)
                                                    : (word & 0xFF00) | value);
}

struct List {
  std::uint32_t start;
  BlockType type;
};
constexpr std::array kLists{
    List{segment1::kObList, BlockType::Ob}, List{segment1::kFbList, BlockType::Fb},
    List{segment1::kDbList, BlockType::Db}, List{segment1::kSbList, BlockType::Sb},
    List{segment1::kPbList, BlockType::Pb}};

std::uint16_t swapped(std::uint32_t word) {
  return static_cast<std::uint16_t>((word & 0xFF) << 8 | (word >> 8 & 0xFF));
}

// An entry: offset and segment address, high and low byte exchanged (S5-MEM-06).
std::uint8_t listByte(const Layout& layout, const Entry& entry, BlockType type,
                      std::uint32_t offset) {
  const bool isData = type == BlockType::Db;
  const std::uint32_t start = isData || layout.byteOffsets ? entry.start * 2 : entry.start;
  const std::uint16_t word = !entry.present   ? std::uint16_t{0}
                             : offset % 4 < 2 ? swapped(start)
                                              : swapped(isData ? layout.data : layout.program);
  return byteOf(word, offset);
}

std::optional<std::uint8_t> systemByte(const Machine& m, std::uint32_t offset) {
  using namespace segment1;
  if (offset < kOutputs) return m.inputs[offset];
  if (offset < kFlags) return m.outputs[offset - kOutputs];
  if (offset < kTimers) return m.flags[offset - kFlags];
  if (offset < kCounters) return byteOf(m.timers[(offset - kTimers) / 2].word(), offset);
  if (offset < kCounters + 2 * kCells)
    return byteOf(m.counters[(offset - kCounters) / 2].word(), offset);
  for (const List& list : kLists) {
    const auto entries = m.blocks.list(list.type);
    const std::uint32_t index = (offset - list.start) / 4;
    if (offset >= list.start && index < entries.size())
      return listByte(m.layout, entries[index], list.type, offset);
  }
  if (offset >= kEnd) return std::nullopt;
  return std::uint8_t{0};
}

bool writeSystemByte(Machine& m, std::uint32_t offset, std::uint8_t value) {
  using namespace segment1;
  if (offset < kOutputs)
    m.inputs[offset] = value;
  else if (offset < kFlags)
    m.outputs[offset - kOutputs] = value;
  else if (offset < kTimers)
    m.flags[offset - kFlags] = value;
  else if (offset < kCounters) {
    Timer& timer = m.timers[(offset - kTimers) / 2];
    timer.setWord(withByte(timer.word(), offset, value));
  } else if (offset < kCounters + 2 * kCells) {
    Counter& counter = m.counters[(offset - kCounters) / 2];
    counter.setWord(withByte(counter.word(), offset, value));
  }
  return offset < kEnd;  // the rest belongs to the system program and keeps its values
}

}  // namespace

bool readable(std::uint32_t segment) { return segment >= 1 && segment <= 10; }
bool writable(std::uint32_t segment) { return segment >= 1 && segment <= 6; }

std::optional<std::uint8_t> readByte(const Machine& m, std::uint32_t segment,
                                     std::uint32_t offset) {
  if (segment == 1) return systemByte(m, offset);
  if (segment != kProgram && segment != kData) return std::uint8_t{0};  // OP-43
  const auto& memory = segment == kProgram ? m.blocks.program() : m.blocks.data();
  if (offset / 2 >= memory.size()) return std::nullopt;
  return byteOf(memory[offset / 2], offset);
}

bool writeByte(Machine& m, std::uint32_t segment, std::uint32_t offset, std::uint8_t value) {
  if (segment == 1) return writeSystemByte(m, offset, value);
  if (segment != kProgram && segment != kData) return true;
  const bool code = segment == kProgram;
  auto& memory = code ? m.blocks.program() : m.blocks.data();
  const std::uint32_t word = offset / 2;
  if (word >= memory.size()) return false;
  const std::uint16_t changed = withByte(memory[word], offset, value);
  if (code)
    m.blocks.patch(word, changed);
  else
    memory[word] = changed;
  return true;
}

std::optional<std::uint16_t> readWord(const Machine& m, std::uint32_t segment,
                                      std::uint32_t offset) {
  const auto high = readByte(m, segment, offset & ~1u), low = readByte(m, segment, offset | 1u);
  if (!high || !low) return std::nullopt;
  return static_cast<std::uint16_t>(*high << 8 | *low);
}

bool writeWord(Machine& m, std::uint32_t segment, std::uint32_t offset, std::uint16_t value) {
  return writeByte(m, segment, offset & ~1u, static_cast<std::uint8_t>(value >> 8)) &&
         writeByte(m, segment, offset | 1u, static_cast<std::uint8_t>(value));
}

}  // namespace merker::sinumerik
