// Transport sizes: in an item of a request the type of its elements, in a data item the unit of its
// length. Two lists of codes that share names and no numbers.
#pragma once

#include <cstdint>

namespace merker::s7comm {

// Of elements.
enum class ElementType : std::uint8_t {
  Bit = 0x01,
  Byte = 0x02,
  Char = 0x03,
  Word = 0x04,
  Int = 0x05,
  DWord = 0x06,
  DInt = 0x07,
  Real = 0x08,
  Date = 0x09,
  TimeOfDay = 0x0A,
  Time = 0x0B,
  S5Time = 0x0C,
  DateAndTime = 0x0F,
  Counter = 0x1C,
  Timer = 0x1D
};

// Of data.
enum class DataUnit : std::uint8_t {
  None = 0x00,
  Bit = 0x03,    // length in bits
  Byte = 0x04,   // bytes, words, double words: in bits
  Int = 0x05,    // in bits
  DInt = 0x06,   // in bytes
  Real = 0x07,   // in bytes
  Octets = 0x09  // in bytes
};

struct ElementRow {
  ElementType type;
  std::uint8_t bytes;
  DataUnit answer;  // what a CPU answers with
};

// Null: no S7-300 knows it.
const ElementRow* findElement(std::uint8_t code);

// Octets of data whose length field says this much.
constexpr std::uint32_t octets(std::uint8_t unit, std::uint32_t length) {
  const bool bits = unit >= static_cast<std::uint8_t>(DataUnit::Bit) &&
                    unit <= static_cast<std::uint8_t>(DataUnit::Int);
  return bits ? (length + 7) / 8 : length;
}
// What the length field of so many octets says; a bit is one.
constexpr std::uint32_t lengthField(DataUnit unit, std::uint32_t count) {
  if (unit == DataUnit::Bit) return 1;
  return unit == DataUnit::Byte || unit == DataUnit::Int ? count * 8 : count;
}

}  // namespace merker::s7comm
