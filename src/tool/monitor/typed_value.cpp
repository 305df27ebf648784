// A value as the user types it into a variable table.
#include <charconv>
#include <cmath>

#include "address/constant.h"
#include "base/bcd.h"
#include "base/text.h"
#include "mc5/constant.h"
#include "mc5/s5_float.h"
#include "monitor/display_format.h"
#include "scenario/term.h"

namespace merker::monitor {
namespace {

using enum DisplayFormat;

std::optional<std::uint32_t> digits(std::string_view text, int base) {
  std::uint32_t value = 0;
  std::string plain;
  if (base == 10 && text.starts_with('+')) text.remove_prefix(1);
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

// Digits without prefix mean what the format says.
std::optional<std::uint32_t> plainDigits(std::string_view text, DisplayFormat format,
                                         unsigned width) {
  if (format == Hex) return digits(text, 16);
  if (format == Bin) return digits(text, 2);
  if (format == Bcd) return bcdDigits(text, width);
  if (format == Unsigned) return digits(text, 10);
  if (format == Dec) return signedDigits(text, width);
  return std::nullopt;
}

bool takesDigits(DisplayFormat format) {
  return format == Hex || format == Bin || format == Bcd || format == Unsigned || format == Dec;
}

// A plain number is the count: 0 to 999, as `L C#` takes it (S7-CNT).
std::optional<std::uint32_t> count(std::string_view text) {
  return text.starts_with('-') ? std::nullopt : bcdDigits(text, 16);
}

bool isTimer(const address::Reference& r) { return r.operand.kind == address::OperandKind::Timer; }
bool isCounter(const address::Reference& r) {
  return r.operand.kind == address::OperandKind::Counter;
}

struct TypeRow {
  TypeCode type;
  DisplayFormat format;
};
constexpr TypeRow kTypes[] = {
    {TypeCode::Bool, Bool},
    {TypeCode::Char, Char},
    {TypeCode::Int, Dec},
    {TypeCode::DInt, Dec},
    {TypeCode::Real, Real},
    {TypeCode::Date, Date},
    {TypeCode::TimeOfDay, TimeOfDay},
    {TypeCode::Time, Time},
    {TypeCode::S5Time, S5Time},
    {TypeCode::Timer, S5Time},
    {TypeCode::Counter, Counter},
};

// What is awaited here: the column's format, or with AUTO what the operand is. AUTO: anything.
DisplayFormat awaited(const address::Reference& reference, DisplayFormat format) {
  const bool number = format == Dec || format == Unsigned || format == Bcd;
  if (isCounter(reference) && (number || format == Automatic)) return Counter;
  if (format != Automatic) return format;
  if (isTimer(reference)) return S5Time;
  for (const TypeRow& row : kTypes)
    if (row.type == reference.type) return row.format;
  return Automatic;
}

// Notations that say bits and no value fit anywhere.
bool isPattern(ConstantFormat format) {
  using enum ConstantFormat;
  return format == Boolean || format == Byte || format == Binary || format == Bytes ||
         format == Word || format == LongBinary || format == LongBytes || format == DWord;
}

bool isInteger(ConstantFormat format) {
  return format == ConstantFormat::Integer || format == ConstantFormat::LongInteger;
}

// Whether a constant of this notation is a value of the kind that is awaited.
bool belongs(ConstantFormat constant, DisplayFormat kind) {
  if (isPattern(constant)) return true;
  switch (kind) {
    case Bool:
      return isInteger(constant);
    case Hex:
    case Bin:
      return !isInteger(constant) && constant != ConstantFormat::Real;
    case Char:
      return constant == ConstantFormat::Characters || constant == ConstantFormat::LongCharacters;
    case Real:
      return constant == ConstantFormat::Real || isInteger(constant);
    case Time:
      return constant == ConstantFormat::Time || isInteger(constant);
    case S5Time:
      return constant == ConstantFormat::S5Time;
    case Date:
      return constant == ConstantFormat::Date;
    case TimeOfDay:
      return constant == ConstantFormat::TimeOfDay;
    case Counter:
      return constant == ConstantFormat::Counter;
    case Pointer:
      return constant == ConstantFormat::Pointer;
    case Dec:
    case Unsigned:
    case Bcd:
      return isInteger(constant);
    default:
      return true;
  }
}

// A duration is one however it is written: T#5S is S5T#5S for a timer, and the other way.
std::optional<Constant> withDuration(const Constant& constant, DisplayFormat kind) {
  if (kind == S5Time && constant.format == ConstantFormat::Time) {
    const auto word = encodeS5Time(constant.bits);
    return word ? std::optional(Constant{ConstantFormat::S5Time, *word}) : std::nullopt;
  }
  if (kind == Time && constant.format == ConstantFormat::S5Time) {
    const auto length = decodeS5Time(static_cast<std::uint16_t>(constant.bits));
    return length ? std::optional(Constant{ConstantFormat::Time, *length}) : std::nullopt;
  }
  return constant;
}

TypeCode typeFor(const address::Reference& reference, DisplayFormat kind, unsigned width) {
  if (kind == Real) return TypeCode::Real;
  if (kind == Automatic && reference.type != TypeCode::Void) return reference.type;
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

// Without digits of the format: a constant as AWL writes it.
Result<std::uint32_t> parseNotation(const address::Reference& reference, std::string_view text,
                                    DisplayFormat kind) {
  const Position at{"", 0, 0, 0};
  const unsigned width = simulator::bitWidth(reference);
  const auto wrong = [&] {
    return makeProblem(ProblemCode::P1210, at, std::string(text), name(kind));
  };
  auto constant = parseConstant(text, at);
  if (!constant && kind != Automatic) return wrong();
  if (!constant) return constant.error();
  const auto converted = withDuration(*constant, kind);
  if (!converted || !belongs(converted->format, kind)) return wrong();
  const Constant adapted = simulator::adapt(*converted, typeFor(reference, kind, width));
  if (tooWide(adapted, width))
    return makeProblem(ProblemCode::P0955, at, std::string(text), reference.text, width);
  return width == 32 ? adapted.bits : adapted.bits & ((1u << width) - 1);
}

// KG +1500000+01, the same without KG, or 1.5.
Result<std::uint32_t> parseFloat(std::string_view text) {
  const bool word = equalsIgnoreCase(text.substr(0, 2), "KG");
  const auto bits = mc5::constantBits(mc5::Format::Float, word ? trim(text.substr(2)) : text);
  if (bits) return *bits;
  double value = 0;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool number = error == std::errc{} && end == digits.data() + digits.size();
  const mc5::FloatResult result = mc5::fromDouble(number ? value : 0);
  if (number && std::isfinite(value) && result.range == mc5::FloatRange::Fits) return result.bits;
  return makeProblem(ProblemCode::P1210, Position{"", 0, 0, 0}, std::string(text), name(Kg));
}

}  // namespace

Result<std::uint32_t> parseValue(const address::Reference& reference, std::string_view text,
                                 DisplayFormat format) {
  text = trim(text);
  if (format == Kg) return parseFloat(text);
  const unsigned width = simulator::bitWidth(reference);
  const DisplayFormat kind = awaited(reference, format);
  // With AUTO a number is read as a constant, whose width is looked at.
  const bool chosen = format != Automatic || kind == Counter;
  const auto bits = kind == Counter ? count(text)
                    : chosen        ? plainDigits(text, kind, width)
                                    : std::nullopt;
  const bool bare = text.find_first_of("#'") == std::string_view::npos;
  if (!bits && chosen && bare && takesDigits(kind) && width > 1)
    return makeProblem(ProblemCode::P1210, Position{"", 0, 0, 0}, std::string(text), name(kind));
  if (!bits) return parseNotation(reference, text, kind);
  if (width < 32 && *bits >> width != 0)
    return makeProblem(ProblemCode::P0955, Position{"", 0, 0, 0}, std::string(text), reference.text,
                       width);
  return *bits;
}

}  // namespace merker::monitor
