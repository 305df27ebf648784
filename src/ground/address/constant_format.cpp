// Constants and values as text.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "address/notation.h"
#include "base/bcd.h"

namespace merker {
namespace {

struct FormatRow {
  ConstantFormat format;
  unsigned bits;
  TypeCode type;
};
constexpr std::array kFormats{
    FormatRow{ConstantFormat::Boolean, 1, TypeCode::Bool},
    FormatRow{ConstantFormat::Byte, 8, TypeCode::Byte},
    FormatRow{ConstantFormat::Binary, 16, TypeCode::Word},
    FormatRow{ConstantFormat::Integer, 16, TypeCode::Int},
    FormatRow{ConstantFormat::Characters, 16, TypeCode::Word},
    FormatRow{ConstantFormat::Bytes, 16, TypeCode::Word},
    FormatRow{ConstantFormat::Word, 16, TypeCode::Word},
    FormatRow{ConstantFormat::Counter, 16, TypeCode::Word},
    FormatRow{ConstantFormat::Date, 16, TypeCode::Date},
    FormatRow{ConstantFormat::S5Time, 16, TypeCode::S5Time},
    FormatRow{ConstantFormat::Real, 32, TypeCode::Real},
    FormatRow{ConstantFormat::LongBinary, 32, TypeCode::DWord},
    FormatRow{ConstantFormat::LongInteger, 32, TypeCode::DInt},
    FormatRow{ConstantFormat::Pointer, 32, TypeCode::Pointer},
    FormatRow{ConstantFormat::LongCharacters, 32, TypeCode::DWord},
    FormatRow{ConstantFormat::LongBytes, 32, TypeCode::DWord},
    FormatRow{ConstantFormat::DWord, 32, TypeCode::DWord},
    FormatRow{ConstantFormat::Time, 32, TypeCode::Time},
    FormatRow{ConstantFormat::TimeOfDay, 32, TypeCode::TimeOfDay},
};
static_assert([] {
  for (std::size_t i = 0; i < kFormats.size(); ++i)
    if (kFormats[i].format != static_cast<ConstantFormat>(i)) return false;
  return kFormats.size() == static_cast<std::size_t>(ConstantFormat::TimeOfDay) + 1;
}());

const FormatRow& row(ConstantFormat format) { return kFormats[static_cast<std::size_t>(format)]; }

std::uint32_t masked(std::uint32_t bits, unsigned width) {
  return width >= 32 ? bits : bits & ((1u << width) - 1);
}

std::string hexadecimal(std::uint32_t bits, unsigned width) {
  if (width <= 8) return fmt::format("B#16#{:02X}", bits);
  return width == 16 ? fmt::format("W#16#{:04X}", bits) : fmt::format("DW#16#{:08X}", bits);
}

float toFloat(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Exponents have three digits: 1.230000e+001.
std::string exponential(float value, int decimals) {
  const std::string text = fmt::format("{:.{}e}", value, decimals);
  const std::size_t exponent = text.find('e') + 2;
  return text.substr(0, exponent) + std::string(3 - (text.size() - exponent), '0') +
         text.substr(exponent);
}

bool readsAs(const std::string& text, const Constant& constant) {
  const auto again = parseConstant(text, {});
  return again && again->bits == constant.bits;
}

// Seven digits as STEP 7 shows them if they say it all, else the nine that always do.
std::string exactReal(const Constant& constant) {
  const float value = toFloat(constant.bits);
  if (!std::isfinite(value)) return {};
  std::string text = exponential(value, 6);
  return readsAs(text, constant) ? text : exponential(value, 8);
}

std::string counter(std::uint32_t bits) {
  const auto count = bits < 0x1000 ? fromBcd(bits, 3) : std::nullopt;
  return count ? fmt::format("C#{}", *count) : std::string();
}

std::string pointerText(std::uint32_t bits, Mnemonics mnemonics) {
  struct Name {
    Area area;
    std::string_view german, international;
  };
  constexpr Name kNames[] = {
      {Area::None, "", ""},           {Area::Peripheral, "P", "P"}, {Area::Input, "E", "I"},
      {Area::Output, "A", "Q"},       {Area::Flag, "M", "M"},       {Area::DataBlock, "DBX", "DBX"},
      {Area::Instance, "DIX", "DIX"}, {Area::Local, "L", "L"},      {Area::CallerLocal, "V", "V"}};
  const BitAddress address = pointerAddress(bits);
  for (const Name& name : kNames) {
    if (pointer(name.area, address) != bits) continue;
    const auto area = mnemonics == Mnemonics::German ? name.german : name.international;
    return fmt::format("P#{}{}.{}", area, address / 8, address % 8);
  }
  return {};
}

// Binary digits in groups of eight; a long constant shows all 32 so that it stays one.
std::string binary(std::uint32_t bits, int digits) {
  std::string text = "2#";
  for (int i = digits - 1; i >= 0; --i) {
    text += (bits >> i & 1) != 0 ? '1' : '0';
    if (i % 8 == 0 && i != 0) text += '_';
  }
  return text;
}

std::string characters(std::uint32_t bits, unsigned least, unsigned most) {
  std::string bytes;
  for (unsigned i = most; i-- > 0;) {
    const auto byte = static_cast<char>(bits >> (8 * i) & 0xFF);
    if (byte != 0 || !bytes.empty() || i < least) bytes += byte;
  }
  return formatCharacters(bytes);
}

std::string bytes(std::uint32_t bits, unsigned count) {
  std::string text = "B#(";
  for (unsigned i = count; i-- > 0;)
    text += fmt::format("{}{}", bits >> (8 * i) & 0xFF, i > 0 ? "," : ")");
  return text;
}

// Empty if the notation cannot express the bits.
std::string inNotation(const Constant& constant, Mnemonics mnemonics) {
  const std::uint32_t bits = constant.bits;
  switch (constant.format) {
    case ConstantFormat::Boolean:
      return bits != 0 ? "TRUE" : "FALSE";
    case ConstantFormat::Binary:
      return binary(bits, 16);
    case ConstantFormat::LongBinary:
      return binary(bits, 32);
    case ConstantFormat::Integer:
      return fmt::format("{}", static_cast<std::int16_t>(bits));
    case ConstantFormat::LongInteger:
      return fmt::format("L#{}", static_cast<std::int32_t>(bits));
    case ConstantFormat::Characters:
      return characters(bits, 1, 2);
    case ConstantFormat::LongCharacters:
      return characters(bits, 3, 4);
    case ConstantFormat::Bytes:
      return bytes(bits, 2);
    case ConstantFormat::LongBytes:
      return bytes(bits, 4);
    case ConstantFormat::Counter:
      return counter(bits);
    case ConstantFormat::Date:
      return notation::writeDate(bits);
    case ConstantFormat::S5Time:
      return notation::writeS5Time(bits);
    case ConstantFormat::Real:
      return exactReal(constant);
    case ConstantFormat::Pointer:
      return pointerText(bits, mnemonics);
    case ConstantFormat::Time:
      return notation::writeTime(bits);
    case ConstantFormat::TimeOfDay:
      return notation::writeTimeOfDay(bits);
    case ConstantFormat::Byte:
    case ConstantFormat::Word:
    case ConstantFormat::DWord:
      break;
  }
  return {};
}

struct Display {
  TypeCode type;
  unsigned bits;
  ConstantFormat format;
};
constexpr Display kDisplays[] = {
    {TypeCode::Bool, 1, ConstantFormat::Boolean},
    {TypeCode::Byte, 8, ConstantFormat::Byte},
    {TypeCode::Char, 8, ConstantFormat::Characters},
    {TypeCode::Word, 16, ConstantFormat::Word},
    {TypeCode::Int, 16, ConstantFormat::Integer},
    {TypeCode::DInt, 32, ConstantFormat::LongInteger},
    {TypeCode::Real, 32, ConstantFormat::Real},
    {TypeCode::Date, 16, ConstantFormat::Date},
    {TypeCode::TimeOfDay, 32, ConstantFormat::TimeOfDay},
    {TypeCode::Time, 32, ConstantFormat::Time},
    {TypeCode::S5Time, 16, ConstantFormat::S5Time},
    {TypeCode::Timer, 16, ConstantFormat::S5Time},
    {TypeCode::Counter, 16, ConstantFormat::Counter},
    {TypeCode::Pointer, 32, ConstantFormat::Pointer},
};

}  // namespace

unsigned bitWidth(ConstantFormat format) { return row(format).bits; }

TypeCode naturalType(const Constant& constant) {
  if (constant.format == ConstantFormat::Characters && constant.bits <= 0xFF) return TypeCode::Char;
  return row(constant.format).type;
}

std::string formatConstant(const Constant& constant, Mnemonics mnemonics) {
  const unsigned width = bitWidth(constant.format);
  const Constant clean{constant.format, masked(constant.bits, width)};
  const std::string text = inNotation(clean, mnemonics);
  return !text.empty() && readsAs(text, clean) ? text : hexadecimal(clean.bits, width);
}

std::string formatValue(TypeCode type, std::uint32_t bits, Mnemonics mnemonics) {
  for (const Display& display : kDisplays) {
    if (display.type != type) continue;
    const std::uint32_t value = masked(bits, display.bits);
    if (type == TypeCode::Real && std::isfinite(toFloat(value)))
      return exponential(toFloat(value), 6);
    const std::string text = inNotation({display.format, value}, mnemonics);
    return text.empty() ? hexadecimal(value, display.bits) : text;
  }
  return hexadecimal(bits, 32);
}

}  // namespace merker
