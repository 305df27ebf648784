// How an S5D file is laid out (docs/formats/s5d.md): everything lies in records of 128 bytes. Words
// of blocks have their high byte first, those of directories their low byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace merker::s5d {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kRecord = 128;
constexpr std::size_t kNameLength = 8;

// Header of the file and, with the same places, of a section.
constexpr std::size_t kName = 8;             // of the file; a section begins with it
constexpr std::size_t kHeaderRecords = 18;   // file: first record of data; section: of its header
constexpr std::size_t kSize = 20;            // in records
constexpr std::size_t kCount = 22;           // of sections; of blocks
constexpr std::size_t kDirectory = 68;       // sections or blocks, one entry each
constexpr std::size_t kSectionEntry = 19;    // bytes
constexpr std::size_t kSectionRecord = 15;   // in the entry: the first record of the section
constexpr std::size_t kBlockEntry = 15;      // bytes
constexpr std::size_t kMostInSection = 255;  // its count is one byte

// Block with the synchronisation pattern.
constexpr std::uint8_t kSync = 0x70;
constexpr std::size_t kType = 2, kNumber = 3, kLibrary = 5, kLength = 8, kBody = 10;
// Pre-header.
constexpr std::size_t kPreNumber = 1, kPreLength = 4, kPreRest = 6, kPreEntries = 8;

constexpr std::size_t recordsFor(std::size_t bytes) { return (bytes + kRecord - 1) / kRecord; }

// 0 beyond the end.
constexpr std::uint8_t byteAt(Bytes bytes, std::size_t at) {
  return at < bytes.size() ? bytes[at] : std::uint8_t{0};
}
constexpr std::uint16_t wordAt(Bytes bytes, std::size_t at) {
  return static_cast<std::uint16_t>(byteAt(bytes, at) << 8 | byteAt(bytes, at + 1));
}
constexpr std::uint16_t littleAt(Bytes bytes, std::size_t at) {
  return static_cast<std::uint16_t>(byteAt(bytes, at + 1) << 8 | byteAt(bytes, at));
}

}  // namespace merker::s5d
