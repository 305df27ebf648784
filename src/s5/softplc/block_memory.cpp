#include "softplc/block_memory.h"

#include <algorithm>

namespace merker::sinumerik {
namespace {

using mc5::BlockId;
using mc5::BlockType;
using mc5::kHeaderWords;

constexpr std::uint8_t kValid = 0x40;

struct TypeRow {
  BlockType type;
  std::uint8_t code;
  std::uint16_t numbers;  // 0..numbers-1 (S5-BLK-03, -04)
};
constexpr std::array kTypes{TypeRow{BlockType::Ob, 0x10, 64}, TypeRow{BlockType::Pb, 0x04, 256},
                            TypeRow{BlockType::Sb, 0x02, 256}, TypeRow{BlockType::Fb, 0x08, 256},
                            TypeRow{BlockType::Db, 0x01, 256}};

const TypeRow& row(BlockType type) { return kTypes[static_cast<std::size_t>(type)]; }

}  // namespace

std::uint8_t typeCode(BlockType type) { return row(type).code | kValid; }

std::optional<BlockType> blockType(std::uint8_t code) {
  for (const TypeRow& r : kTypes)
    if ((r.code | kValid) == code) return r.type;
  return std::nullopt;
}

BlockMemory::BlockMemory(std::uint32_t programWords, std::uint32_t dataWords)
    : program_(programWords), data_(dataWords) {
  for (const TypeRow& r : kTypes) lists_[static_cast<std::size_t>(r.type)].resize(r.numbers);
}

Entry& BlockMemory::entry(BlockId id) {
  return lists_[static_cast<std::size_t>(id.type)][id.number];
}

const Entry& BlockMemory::find(BlockId id) const {
  static const Entry kNone;
  const auto& list = lists_[static_cast<std::size_t>(id.type)];
  return id.number < list.size() ? list[id.number] : kNone;
}

std::span<const Entry> BlockMemory::list(BlockType type) const {
  return lists_[static_cast<std::size_t>(type)];
}

bool BlockMemory::append(BlockId id, std::uint32_t library, std::span<const std::uint16_t> words) {
  const bool isData = id.type == BlockType::Db;
  auto& memory = isData ? data_ : program_;
  std::uint32_t& used = isData ? dataUsed_ : programUsed_;
  const std::size_t length = words.size() + kHeaderWords;
  if (used + length > memory.size()) return false;
  const std::uint16_t header[kHeaderWords] = {
      kSynchronisation, static_cast<std::uint16_t>(typeCode(id.type) << 8 | id.number),
      static_cast<std::uint16_t>(library >> 16 & 0xFF), static_cast<std::uint16_t>(library),
      static_cast<std::uint16_t>(length)};
  std::copy(std::begin(header), std::end(header), memory.begin() + used);
  std::copy(words.begin(), words.end(), memory.begin() + used + kHeaderWords);
  entry(id) = {true, used + kHeaderWords, static_cast<std::uint32_t>(words.size())};
  used += static_cast<std::uint32_t>(length);
  ++version_;
  if (!isData) codeChanged();
  return true;
}

bool BlockMemory::load(const mc5::Block& block) {
  if (block.id.number >= row(block.id.type).numbers) return false;
  const BlockMemory before = *this;  // the old block stays if the new one finds no room
  erase(block.id);
  if (append(block.id, block.library, block.words)) return true;
  *this = before;
  return false;
}

bool BlockMemory::createData(std::uint16_t number, std::uint32_t words) {
  return append({BlockType::Db, number}, 0, std::vector<std::uint16_t>(words));
}

// What lies behind moves up; there are no gaps.
bool BlockMemory::erase(BlockId id) {
  const Entry gone = find(id);
  if (!gone.present) return false;
  const bool isData = id.type == BlockType::Db;
  auto& memory = isData ? data_ : program_;
  std::uint32_t& used = isData ? dataUsed_ : programUsed_;
  const std::uint32_t length = gone.length + kHeaderWords, first = gone.start - kHeaderWords;
  std::copy(memory.begin() + first + length, memory.begin() + used, memory.begin() + first);
  std::fill(memory.begin() + (used - length), memory.begin() + used, std::uint16_t{0});
  used -= length;
  ++version_;
  buildLists();
  return true;
}

void BlockMemory::restore(std::span<const std::uint16_t> program,
                          std::span<const std::uint16_t> data) {
  const auto copy = [](std::span<const std::uint16_t> from, std::vector<std::uint16_t>& to) {
    const std::size_t words = std::min(from.size(), to.size());
    std::fill(std::copy_n(from.begin(), words, to.begin()), to.end(), std::uint16_t{0});
    return static_cast<std::uint32_t>(words);
  };
  programUsed_ = copy(program, program_);
  dataUsed_ = copy(data, data_);
  buildLists();
}

void BlockMemory::patch(std::uint32_t word, std::uint16_t value) {
  patched_ = patched_ || program_[word] != value;
  program_[word] = value;
}

std::optional<BlockMemory::Damage> BlockMemory::buildLists() {
  for (auto& list : lists_) std::fill(list.begin(), list.end(), Entry{});
  ++version_;
  codeChanged();
  if (auto damage = scan(kProgramSegment, program_, programUsed_)) return damage;
  return scan(kDataSegment, data_, dataUsed_);
}

std::optional<BlockMemory::Damage> BlockMemory::scan(std::uint8_t segment,
                                                     std::vector<std::uint16_t>& memory,
                                                     std::uint32_t used) {
  for (std::uint32_t at = 0; at < used; at += memory[at + 4])
    if (auto damage = takeIn(segment, std::span(memory).first(used), at)) return damage;
  return std::nullopt;
}

std::optional<BlockMemory::Damage> BlockMemory::takeIn(std::uint8_t segment,
                                                       std::span<const std::uint16_t> memory,
                                                       std::uint32_t at) {
  if (memory[at] != kSynchronisation || at + kHeaderWords > memory.size())
    return Damage{segment, at, true, false};
  const auto type = blockType(static_cast<std::uint8_t>(memory[at + 1] >> 8));
  const std::uint16_t number = memory[at + 1] & 0xFF, length = memory[at + 4];
  const bool fits = length >= kHeaderWords && at + length <= memory.size();
  if (!type || !fits || number >= row(*type).numbers ||
      (*type == BlockType::Db) != (segment == kDataSegment))
    return Damage{segment, at, false, !fits};
  entry({*type, number}) = {true, at + kHeaderWords,
                            static_cast<std::uint32_t>(length - kHeaderWords)};
  return std::nullopt;
}

}  // namespace merker::sinumerik
