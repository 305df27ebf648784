// Operand areas of an S7 CPU with the codes that pointers carry (STEP 7 layout, requirement
// S7-IND-02).
#pragma once

#include <cstdint>

namespace merker {

enum class Area : std::uint8_t {
  None = 0,           // in pointers: area-internal
  Peripheral = 0x80,  // P: PE when read, PA when written
  Input = 0x81,       // E / I
  Output = 0x82,      // A / Q
  Flag = 0x83,        // M
  DataBlock = 0x84,   // DB: the block in the DB register
  Instance = 0x85,    // DI: the block in the DI register
  Local = 0x86,       // L: local data of the running block
  CallerLocal = 0x87  // V: local data of the block that called
};

enum class Width : std::uint8_t { Bit, Byte, Word, DWord };

constexpr unsigned byteCount(Width width) {
  return width == Width::DWord ? 4 : width == Width::Word ? 2 : 1;
}

// German and international mnemonics (S7-MNE). A source uses one of them, never both.
enum class Mnemonics : std::uint8_t { German, International };

// A bit address counts bits: byte * 8 + bit.
using BitAddress = std::uint32_t;
constexpr BitAddress bitAddress(std::uint32_t byte, std::uint32_t bit = 0) {
  return byte * 8 + bit;
}

// The 32-bit pointer word: area code in bits 31..24, bit address in bits 18..0.
constexpr std::uint32_t pointer(Area area, BitAddress address) {
  return static_cast<std::uint32_t>(area) << 24 | (address & 0x7FFFF);
}
constexpr Area pointerArea(std::uint32_t value) { return static_cast<Area>(value >> 24); }
constexpr BitAddress pointerAddress(std::uint32_t value) { return value & 0x7FFFF; }

}  // namespace merker
