// Segments 5 (user program) and 6 (user data): words in battery-backed RAM, blocks with their
// headers one behind the other, and the block lists that the operating system builds from them
// (S5-BLK-08, -09, S5-MEM).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mc5/block.h"

namespace merker::sinumerik {

// Where a block lies. `start` is the word of the segment behind the header.
struct Entry {
  bool present = false;
  std::uint32_t start = 0, length = 0;  // words
};

// Header of a block in memory (OP-02).
constexpr std::uint16_t kSynchronisation = 0x7070;
constexpr std::uint8_t kProgramSegment = 5, kDataSegment = 6;
std::uint8_t typeCode(mc5::BlockType type);  // with the mark "valid"
std::optional<mc5::BlockType> blockType(std::uint8_t code);

class BlockMemory {
 public:
  // Sizes in words.
  BlockMemory(std::uint32_t programWords, std::uint32_t dataWords);

  // Takes a block in, replacing one of the same type and number. False: no room.
  bool load(const mc5::Block& block);
  // A data block of zeros, as FB 11 and the operating system create them.
  bool createData(std::uint16_t number, std::uint32_t words);
  bool erase(mc5::BlockId id);

  // Both segments from their beginnings, as the battery kept them; the rest becomes 0.
  void restore(std::span<const std::uint16_t> program, std::span<const std::uint16_t> data);

  const Entry& find(mc5::BlockId id) const;
  // Reads the headers again, as at start-up. The first header that is no header ends it; its place
  // and segment come back (alarms 6131, 6132, 6134, 6135).
  struct Damage {
    std::uint8_t segment = 0;
    std::uint32_t word = 0;
    bool synchronisation = false;  // else: type or number, or
    bool length = false;
  };
  std::optional<Damage> buildLists();

  std::vector<std::uint16_t>& program() { return program_; }
  const std::vector<std::uint16_t>& program() const { return program_; }
  std::vector<std::uint16_t>& data() { return data_; }
  const std::vector<std::uint16_t>& data() const { return data_; }
  std::uint32_t programUsed() const { return programUsed_; }
  std::uint32_t dataUsed() const { return dataUsed_; }
  // Changes with each block that comes or goes: caches of decoded code look at it.
  std::uint64_t version() const { return version_; }
  std::uint64_t codeVersion() const { return codeVersion_; }  // of segment 5 only
  // A program writes into segment 5. Patched until blocks come, go or are listed again.
  void patch(std::uint32_t word, std::uint16_t value);
  bool patched() const { return patched_; }

  std::span<const Entry> list(mc5::BlockType type) const;

 private:
  bool append(mc5::BlockId id, std::uint32_t library, std::span<const std::uint16_t> words);
  std::optional<Damage> scan(std::uint8_t segment, std::vector<std::uint16_t>& memory,
                             std::uint32_t used);
  std::optional<Damage> takeIn(std::uint8_t segment, std::span<const std::uint16_t> memory,
                               std::uint32_t at);
  Entry& entry(mc5::BlockId id);

  std::vector<std::uint16_t> program_, data_;
  std::uint32_t programUsed_ = 0, dataUsed_ = 0;
  std::array<std::vector<Entry>, 5> lists_;  // by BlockType
  void codeChanged() {
    ++codeVersion_;
    patched_ = false;
  }

  std::uint64_t version_ = 0, codeVersion_ = 0;
  bool patched_ = false;
};

}  // namespace merker::sinumerik
