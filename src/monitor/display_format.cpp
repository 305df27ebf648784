#include "monitor/display_format.h"

#include <fmt/format.h>

#include <charconv>

#include "address/constant.h"
#include "base/bcd.h"
#include "base/text.h"
#include "simulator/display.h"
#include "simulator/term.h"

namespace merker::monitor {
namespace {

using enum DisplayFormat;

constexpr FormatRow kRows[] = {
    {Automatic, "AUTO", 1, 32}, {Bool, "BOOL", 1, 1},         {Bin, "BIN", 1, 32},
    {Hex, "HEX", 1, 32},        {Dec, "DEC", 8, 32},          {Unsigned, "UDEC", 1, 32},
    {Bcd, "BCD", 8, 32},        {Char, "CHAR", 8, 32},        {Real, "REAL", 32, 32},
    {S5Time, "S5TIME", 16, 16}, {Time, "TIME", 32, 32},       {Date, "DATE", 16, 16},
    {TimeOfDay, "TOD", 32, 32}, {Counter, "COUNTER", 16, 16}, {Pointer, "POINTER", 32, 32},
};

const FormatRow& row(DisplayFormat format) {
  for (const FormatRow& one : kRows)
    if (one.format == format) return one;
  return kRows[0];
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

std::optional<std::uint32_t> digits(std::string_view text, int base) {
  std::uint32_t value = 0;
  std::string plain;
  for (const char c : text)
    if (c != '_') plain += c;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value, base);
  if (plain.empty() || error != std::errc{} || end != plain.data() + plain.size())
    return std::nullopt;
  return value;
}

// BCD digits with a sign in the highest one.
std::optional<std::uint32_t> bcdDigits(std::string_view text, unsigned width) {
  const bool minus = text.starts_with('-');
  const auto number = digits(minus ? text.substr(1) : text, 10);
  const unsigned places = width / 4 - (width == 8 ? 0 : 1);
  std::uint32_t limit = 1;
  for (unsigned i = 0; i < places; ++i) limit *= 10;
  if (!number || *number >= limit || (minus && width == 8)) return std::nullopt;
  return toBcd(*number, places) | (minus ? 0xFu << (width - 4) : 0);
}

std::optional<std::uint32_t> signedDigits(std::string_view text, unsigned width) {
  const bool minus = text.starts_with('-');
  const auto number = digits(minus ? text.substr(1) : text, 10);
  const std::uint64_t limit = std::uint64_t{1} << (width - 1);
  if (!number || *number > (minus ? limit : limit - 1)) return std::nullopt;
  const std::uint32_t bits = minus ? 0u - *number : *number;
  return width == 32 ? bits : bits & ((1u << width) - 1);
}

bool isDigits(DisplayFormat format) {
  return format == Hex || format == Bin || format == Bcd || format == Unsigned || format == Dec;
}

// Digits without prefix mean what the format says.
std::optional<std::uint32_t> plainDigits(std::string_view text, DisplayFormat format,
                                         unsigned width) {
  if (format == Hex) return digits(text, 16);
  if (format == Bin) return digits(text, 2);
  if (format == Bcd) return bcdDigits(text, width);
  if (format == Counter && text.size() <= 3) return bcdDigits(text, 16);
  if (format == Unsigned) return digits(text, 10);
  if (format == Dec) return signedDigits(text, width);
  return std::nullopt;
}

bool isTimer(const mc7::Reference& r) { return r.operand.kind == mc7::OperandKind::Timer; }
bool isCounter(const mc7::Reference& r) { return r.operand.kind == mc7::OperandKind::Counter; }

TypeCode typeFor(const mc7::Reference& reference, DisplayFormat format, unsigned width) {
  if (format == Real) return TypeCode::Real;
  if (format == Automatic && reference.type != TypeCode::Void) return reference.type;
  return width == 32 ? TypeCode::DInt : TypeCode::Void;
}

bool tooWide(const Constant& constant, unsigned width) {
  if (width == 32) return false;
  const bool integer = constant.format == ConstantFormat::Integer;
  if (integer && width == 8) {
    const auto number = static_cast<std::int16_t>(constant.bits);
    return number < -128 || number > 255;
  }
  return constant.bits >> width != 0;
}

}  // namespace

std::span<const FormatRow> displayFormats() { return kRows; }
std::string_view name(DisplayFormat format) { return row(format).name; }

Result<DisplayFormat> parseFormat(std::string_view text) {
  std::string names;
  for (const FormatRow& one : kRows) {
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

std::string show(const mc7::Reference& reference, std::uint32_t bits, DisplayFormat format) {
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
      return std::to_string(withSign(bits, width));
    case S5Time:
      return s5Time(bits);
    case Bcd:
      return bcd(bits, width);
    case Char:
      return characters(bits, width);
    default:
      return std::to_string(bits);
  }
}

Result<std::uint32_t> parseValue(const mc7::Reference& reference, std::string_view text,
                                 DisplayFormat format) {
  text = trim(text);
  const Position at{"", 0, 0, 0};
  const unsigned width = simulator::bitWidth(reference);
  const auto fitting = [&](std::uint32_t bits) -> Result<std::uint32_t> {
    if (width < 32 && bits >> width != 0)
      return makeProblem(ProblemCode::P0955, at, std::string(text), reference.text, width);
    return bits;
  };
  const bool number = !isTimer(reference) && !isCounter(reference);
  if (isCounter(reference))  // a plain number is the count
    if (const auto bits = bcdDigits(text, 16)) return fitting(*bits);
  if (const auto bits = number ? plainDigits(text, format, width) : std::nullopt)
    return fitting(*bits);
  const bool bare = text.find_first_of("#'") == std::string_view::npos;
  if (number && bare && isDigits(format) && width > 1)
    return makeProblem(ProblemCode::P1210, at, std::string(text), name(format));
  auto constant = parseConstant(text, at);
  if (!constant && format != Automatic)
    return makeProblem(ProblemCode::P1210, at, std::string(text), name(format));
  if (!constant) return constant.error();
  const Constant adapted = simulator::adapt(*constant, typeFor(reference, format, width));
  if (tooWide(adapted, width))
    return makeProblem(ProblemCode::P0955, at, std::string(text), reference.text, width);
  return width == 32 ? adapted.bits : adapted.bits & ((1u << width) - 1);
}

}  // namespace merker::monitor
