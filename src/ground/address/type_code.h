// Data types of STEP 7 with the codes of block interfaces and ANY pointers (S7-IND-13, MC7 section
// 8).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace merker {

enum class TypeCode : std::uint8_t {
  Void = 0x00,
  Bool = 0x01,
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
  DateAndTime = 0x0E,
  Array = 0x10,
  Struct = 0x11,
  String = 0x13,
  Pointer = 0x14,
  FunctionBlock = 0x15,  // multiple instance of an FB
  Any = 0x16,
  BlockFb = 0x17,
  BlockFc = 0x18,
  BlockDb = 0x19,
  BlockSdb = 0x1A,
  SystemFunctionBlock = 0x1B,  // multiple instance of an SFB
  Counter = 0x1C,
  Timer = 0x1D
};

// The keyword of a declaration ("INT", "TIME_OF_DAY"); empty for array, struct and instances.
std::string_view name(TypeCode code);
// Keyword to type, any case, short forms too (TOD, DT). Only types that are one word.
std::optional<TypeCode> typeFromName(std::string_view keyword);
// Bits of a value: 1 for BOOL, 8 … 32 for elementary types, 64 for DT; 0 for all that has no fixed
// width.
unsigned bitWidth(TypeCode code);
constexpr bool isElementary(TypeCode code) {
  return code >= TypeCode::Bool && code <= TypeCode::S5Time;
}
// TIMER, COUNTER, BLOCK_*: handed over as a number (S7-TYPES-22).
constexpr bool isParameterNumber(TypeCode code) {
  return code == TypeCode::Timer || code == TypeCode::Counter ||
         (code >= TypeCode::BlockFb && code <= TypeCode::BlockSdb);
}

}  // namespace merker
