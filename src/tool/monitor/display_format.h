// The display formats of a variable table (S7-SIM-12): how a value is shown and how it is typed in.
// Changing the format never changes the value.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "address/reference.h"
#include "base/result.h"

namespace merker::monitor {

enum class DisplayFormat : std::uint8_t {
  Automatic,  // as the operand's type or width has it
  Bool,
  Bin,
  Hex,
  Dec,       // with sign
  Unsigned,  // DEC without sign
  Bcd,
  Char,
  Real,
  S5Time,
  Time,
  Date,
  TimeOfDay,
  Counter,
  Pointer,
  Kg  // floating point of STEP 5 (S5-NUM-04)
};

struct FormatRow {
  DisplayFormat format;
  std::string_view name;          // "BIN", what commands take
  std::uint8_t shortest, widest;  // bits of the operands it fits
};
std::span<const FormatRow> displayFormats();
std::string_view name(DisplayFormat format);
// "BIN", "bin"; P1208 otherwise.
Result<DisplayFormat> parseFormat(std::string_view text);
bool fits(DisplayFormat format, unsigned bits);
std::string bitsText(DisplayFormat format);  // "16", "8 to 32"

// The value in this format; a pattern that the format cannot express comes out in HEX.
std::string show(const address::Reference& reference, std::uint32_t bits, DisplayFormat format);

// A value as the user types it: any AWL constant, or plain digits in the format (HEX 00FF, BIN
// 1010, BCD 12). P1210, or the problem of the constant; P0955 if it is too wide for the operand.
Result<std::uint32_t> parseValue(const address::Reference& reference, std::string_view text,
                                 DisplayFormat format);

}  // namespace merker::monitor
