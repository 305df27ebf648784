#include "monitor/display_format.h"

#include <fmt/format.h>

#include "address/constant.h"
#include "base/bcd.h"
#include "base/text.h"
#include "mc5/constant.h"
#include "scenario/display.h"
#include "scenario/term.h"

namespace merker::monitor {
namespace {

using enum DisplayFormat;

constexpr FormatRow kDisplayFormatRows[] = {
    {Automatic, "AUTO", 1, 32}, {Bool, "BOOL", 1, 1},         {Bin, "BIN", 1, 32},
    {Hex, "HEX", 1, 32},        {Dec, "DEC", 8, 32},          {Unsigned, "UDEC", 1, 32},
    {Bcd, "BCD", 8, 32},        {Char, "CHAR", 8, 32},        {Real, "REAL", 32, 32},
    {S5Time, "S5TIME", 16, 16}, {Time, "TIME", 32, 32},       {Date, "DATE", 16, 16},
    {TimeOfDay, "TOD", 32, 32}, {Counter, "COUNTER", 16, 16}, {Pointer, "POINTER", 32, 32},
    {Kg, "KG", 32, 32},
};

const FormatRow& row(DisplayFormat format) {
  for (const FormatRow& one : kDisplayFormatRows)
    if (one.format == format) return one;
  return kDisplayFormatRows[0];
}

std::int32_t withSign(std::uint32_t bits, unsigned width) {
  if (width == 8) return static_cast<std::int8_t>(bits);
  if (width == 16) return static_cast<std::int16_t>(bits);
  return static_cast<std::int32_t>(bits);
}

std::string hex(std::uint32_t bits, unsigned width) {
  const char* prefix = width == 32 ? "DW#16#" : width == 16 ? "W#16#" : "B#16#";
  return width == 1 ? std::to_string(bits) : fmt::format("{}{:0{}X}", prefix, bits, width / 4);
}

// In groups of four, as STEP 7 writes them: 2#0000_0000_0000_0101.
std::string binary(std::uint32_t bits, unsigned width) {
  std::string text = "2#";
  for (unsigned i = width; i-- > 0;) {
    text += (bits >> i & 1) != 0 ? '1' : '0';
    if (i % 4 == 0 && i != 0) text += '_';
  }
  return text;
}

// Bits 3..0 of the highest digit are the sign: 1xxx minus (S7-TYPES-14). A byte has none.
std::string bcd(std::uint32_t bits, unsigned width) {
  const unsigned digits = width / 4 - (width == 8 ? 0 : 1);
  const std::uint32_t mask = digits == 8 ? 0xFFFFFFFF : (1u << (4 * digits)) - 1;
  const auto number = fromBcd(bits & mask, digits);
  if (!number) return hex(bits, width);
  const bool minus = width != 8 && (bits >> (width - 1) & 1) != 0;
  return fmt::format("{}{}", minus ? "-" : "", *number);
}

std::string characters(std::uint32_t bits, unsigned width) {
  std::string bytes;
  for (unsigned shift = width; shift > 0; shift -= 8)
    bytes += static_cast<char>(bits >> (shift - 8) & 0xFF);
  return formatCharacters(bytes);
}

// With the shortest base, whatever base it has.
std::string s5Time(std::uint32_t bits) {
  const auto milliseconds = decodeS5Time(static_cast<std::uint16_t>(bits));
  if (!milliseconds) return hex(bits, 16);
  return formatConstant({ConstantFormat::S5Time, encodeS5Time(*milliseconds).value_or(0)});
}

// A counter's word is its count in BCD: as a number it is the count (S7-CNT).
std::string number(const address::Reference& reference, std::uint32_t bits, DisplayFormat format) {
  const unsigned width = simulator::bitWidth(reference);
  if (reference.operand.kind == address::OperandKind::Counter) return bcd(bits, width);
  if (format == Unsigned) return std::to_string(bits);
  return std::to_string(withSign(bits, width));
}

std::optional<ConstantFormat> constantFormat(DisplayFormat format) {
  switch (format) {
    case Real:
      return ConstantFormat::Real;
    case Time:
      return ConstantFormat::Time;
    case Date:
      return ConstantFormat::Date;
    case TimeOfDay:
      return ConstantFormat::TimeOfDay;
    case Counter:
      return ConstantFormat::Counter;
    case Pointer:
      return ConstantFormat::Pointer;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::span<const FormatRow> displayFormats() { return kDisplayFormatRows; }
std::string_view name(DisplayFormat format) { return row(format).name; }

Result<DisplayFormat> parseFormat(std::string_view text) {
  std::string names;
  for (const FormatRow& one : kDisplayFormatRows) {
    if (equalsIgnoreCase(one.name, trim(text))) return one.format;
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  return makeProblem(ProblemCode::P1208, Position{"", 0, 0, 0}, std::string(text), names);
}

bool fits(DisplayFormat format, unsigned bits) {
  return bits >= row(format).shortest && bits <= row(format).widest;
}

std::string bitsText(DisplayFormat format) {
  const FormatRow& one = row(format);
  if (one.shortest == one.widest) return std::to_string(one.shortest);
  return fmt::format("{} to {}", one.shortest, one.widest);
}

std::string show(const address::Reference& reference, std::uint32_t bits, DisplayFormat format) {
  const unsigned width = simulator::bitWidth(reference);
  if (format == Automatic || !fits(format, width)) return simulator::formatOperand(reference, bits);
  if (const auto constant = constantFormat(format)) return formatConstant({*constant, bits});
  switch (format) {
    case Bool:
      return bits != 0 ? "TRUE" : "FALSE";
    case Bin:
      return binary(bits, width);
    case Hex:
      return hex(bits, width);
    case Dec:
    case Unsigned:
      return number(reference, bits, format);
    case S5Time:
      return s5Time(bits);
    case Bcd:
      return bcd(bits, width);
    case Char:
      return characters(bits, width);
    case Kg:
      return mc5::constantText(
          {.kind = mc5::OperandKind::Constant, .format = mc5::Format::Float, .value = bits});
    default:
      return std::to_string(bits);
  }
}

}  // namespace merker::monitor
