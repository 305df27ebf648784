// Numbers, bit patterns and pointers.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "address/notation.h"
#include "base/bcd.h"

namespace merker::notation {
namespace {

// --- numbers in another base ---

struct Hexadecimal {
  ConstantFormat format;
  std::string_view example;
  std::uint64_t highest;
  std::string_view range;
};

Result<Constant> readHexadecimal(const Input& input, std::string_view digits,
                                 const Hexadecimal& form) {
  Scanner text(digits);
  const auto value = text.number(16);
  if (!value || !text.atEnd()) return misspelt(input, form.example);
  if (*value > form.highest) return outside(input, form.range);
  return Constant{form.format, static_cast<std::uint32_t>(*value)};
}

// Two or four bytes 0..255: B#(81, 54).
Result<Constant> readByteList(const Input& input) {
  constexpr std::string_view kExample = "B#(81, 54) or B#(12, 13, 14, 15)";
  Scanner text(input.body.substr(1));
  std::uint32_t bits = 0;
  int count = 0;
  do {
    const auto value = text.number();
    if (!value || ++count > 4) return misspelt(input, kExample);
    if (*value > 255) return outside(input, "0..255 in one of its bytes");
    bits = bits << 8 | static_cast<std::uint32_t>(*value);
  } while (text.take(","));
  if (!text.take(")") || !text.atEnd() || (count != 2 && count != 4))
    return misspelt(input, kExample);
  return Constant{count == 2 ? ConstantFormat::Bytes : ConstantFormat::LongBytes, bits};
}

constexpr Hexadecimal kByte{ConstantFormat::Byte, "B#16#A1", 0xFF, "B#16#0..B#16#FF"};
constexpr Hexadecimal kWord{ConstantFormat::Word, "W#16#ABCD", 0xFFFF, "W#16#0..W#16#FFFF"};
constexpr Hexadecimal kDWord{ConstantFormat::DWord, "DW#16#12345678", 0xFFFFFFFF,
                             "DW#16#0..DW#16#FFFFFFFF"};

Result<Constant> readWithBase(const Input& input, const Hexadecimal& form) {
  if (!input.body.starts_with("16#")) return misspelt(input, form.example);
  return readHexadecimal(input, input.body.substr(3), form);
}

// --- pointers ---

struct PointerArea {
  std::string_view name;
  Area area;
};
constexpr PointerArea kPointerAreas[] = {
    {"", Area::None},   {"P", Area::Peripheral},  {"E", Area::Input},
    {"I", Area::Input}, {"A", Area::Output},      {"Q", Area::Output},
    {"M", Area::Flag},  {"DBX", Area::DataBlock}, {"DIX", Area::Instance},
    {"L", Area::Local}, {"V", Area::CallerLocal}};

// --- decimal numbers ---

struct Signed {
  bool negative;
  std::uint64_t magnitude;
};

std::optional<Signed> readSigned(std::string_view body) {
  Scanner text(body);
  const bool negative = text.take("-");
  if (!negative) text.take("+");
  const auto magnitude = text.number();
  if (!magnitude || !text.atEnd()) return std::nullopt;
  return Signed{negative, *magnitude};
}

Result<Constant> readInteger(const Input& input, Signed number) {
  if (number.magnitude > 0x7FFFu + (number.negative ? 1u : 0u))
    return outside(input, "-32768..32767 of INT; write a DINT with L#");
  const auto magnitude = static_cast<std::uint32_t>(number.magnitude);
  return Constant{ConstantFormat::Integer, (number.negative ? 0u - magnitude : magnitude) & 0xFFFF};
}

// Digits with a point, an exponent or both, without sign: 12.3, 1.23E+01, 1E3.
bool isReal(std::string_view body) {
  Scanner text(body);
  if (!text.number()) return false;
  const bool point = text.take(".");
  if (point && !text.number()) return false;
  const bool exponent = text.take("E");
  if (exponent && !text.take("-")) text.take("+");
  if (exponent && !text.number()) return false;
  return (point || exponent) && text.atEnd();
}

bool isZero(std::string_view digits) {
  return digits.substr(0, digits.find('E')).find_first_of("123456789") == std::string_view::npos;
}

// To the nearest float. What would be denormal or infinite is outside REAL (S7-TYPES-14).
Result<Constant> readReal(const Input& input, bool negative, std::string_view digits) {
  float value = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (isZero(digits))
    value = 0;
  else if (end.ec != std::errc() || !std::isnormal(value))
    return outside(input, "+-1.175495e-38..+-3.402823e+38 of REAL");
  if (negative) value = -value;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return Constant{ConstantFormat::Real, bits};
}

}  // namespace

Result<Constant> readByte(const Input& input) {
  return input.body.starts_with("(") ? readByteList(input) : readWithBase(input, kByte);
}

Result<Constant> readWord(const Input& input) { return readWithBase(input, kWord); }

Result<Constant> readDWord(const Input& input) { return readWithBase(input, kDWord); }

// 16#… without B, W or DW is as wide as its digits: two for a byte, four for a word.
Result<Constant> readPlainHexadecimal(const Input& input) {
  const std::size_t digits = input.body.size();
  return readHexadecimal(input, input.body, digits <= 2 ? kByte : digits <= 4 ? kWord : kDWord);
}

Result<Constant> readBinary(const Input& input) {
  Scanner text(input.body);
  std::uint32_t bits = 0;
  for (const char c : input.body) bits = bits << 1 | (c == '1' ? 1u : 0u);
  if (!text.number(2) || !text.atEnd()) return misspelt(input, "2#0011_1111");
  if (text.digits() > 32) return outside(input, "32 binary digits");
  return Constant{text.digits() > 16 ? ConstantFormat::LongBinary : ConstantFormat::Binary, bits};
}

Result<Constant> readCounter(const Input& input) {
  Scanner text(input.body);
  const auto value = text.number();
  if (!value || !text.atEnd()) return misspelt(input, "C#128");
  if (*value > 999) return outside(input, "C#0..C#999");
  return Constant{ConstantFormat::Counter, toBcd(static_cast<std::uint32_t>(*value), 3)};
}

Result<Constant> readPointer(const Input& input) {
  constexpr std::string_view kExample = "P#10.0 or P#M 10.0 (areas E I A Q M DBX DIX L V P)";
  Scanner text(input.body);
  const std::string_view name = text.letters();
  const auto* const row = std::find_if(std::begin(kPointerAreas), std::end(kPointerAreas),
                                       [name](const PointerArea& r) { return r.name == name; });
  text.skipBlanks();
  const auto byte = text.number();
  const bool point = text.take(".");
  const auto bit = text.number();
  if (row == std::end(kPointerAreas) || !byte || !point || !bit || !text.atEnd())
    return misspelt(input, kExample);
  if (*byte > 65535 || *bit > 7) return outside(input, "0.0..65535.7");
  const auto address =
      bitAddress(static_cast<std::uint32_t>(*byte), static_cast<std::uint32_t>(*bit));
  return Constant{ConstantFormat::Pointer, pointer(row->area, address)};
}

Result<Constant> readLongInteger(const Input& input) {
  const auto number = readSigned(input.body);
  if (!number) return misspelt(input, "L#35434");
  if (number->magnitude > 0x7FFFFFFFu + (number->negative ? 1u : 0u))
    return outside(input, "L#-2147483648..L#2147483647");
  const auto magnitude = static_cast<std::uint32_t>(number->magnitude);
  return Constant{ConstantFormat::LongInteger, number->negative ? 0u - magnitude : magnitude};
}

Result<Constant> readNumber(const Input& input) {
  if (const auto integer = readSigned(input.body)) return readInteger(input, *integer);
  const bool negative = input.body.starts_with("-");
  const std::string_view digits =
      input.body.substr(negative || input.body.starts_with("+") ? 1 : 0);
  if (isReal(digits)) return readReal(input, negative, digits);
  return unknown(input);
}

}  // namespace merker::notation
