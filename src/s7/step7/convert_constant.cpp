// Which constants an elementary type takes.
#include <algorithm>
#include <limits>

#include "step7/initial_value.h"

namespace merker::step7 {
namespace {

// The numbers that an elementary type takes (S7-TYPES, S7-PAR-05). One without a format has 16
// bits, one with L# is too wide for WORD and INT before it comes here.
struct IntegerRange {
  TypeCode type;
  std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
  std::int64_t highest = std::numeric_limits<std::int64_t>::max();
};
constexpr IntegerRange kIntegers[] = {{TypeCode::Bool, 0, 1}, {TypeCode::Byte, -128, 255},
                                      {TypeCode::Word},       {TypeCode::Int},
                                      {TypeCode::DWord},      {TypeCode::DInt}};

bool acceptsInteger(TypeCode type, std::int64_t value) {
  return std::ranges::any_of(kIntegers, [&](const IntegerRange& row) {
    return row.type == type && row.lowest <= value && value <= row.highest;
  });
}

template <typename List, typename Value>
bool isIn(const List& list, Value value) {
  return std::ranges::find(list, value) != std::ranges::end(list);
}

// Types that take a pattern of bits, as long as it is not wider than they are.
constexpr TypeCode kPatterns[] = {TypeCode::Byte,  TypeCode::Char,     TypeCode::Word,
                                  TypeCode::Int,   TypeCode::S5Time,   TypeCode::Date,
                                  TypeCode::DWord, TypeCode::DInt,     TypeCode::Real,
                                  TypeCode::Time,  TypeCode::TimeOfDay};

bool acceptsBits(TypeCode type, unsigned width) {
  return isIn(kPatterns, type) && width <= bitWidth(type);
}

// L#5, W#16#5, DW#16#5 and B#(1,2) say how wide they are, whatever their value (S7-PAR-05).
constexpr ConstantFormat kStatingWidth[] = {ConstantFormat::LongInteger, ConstantFormat::Word,
                                            ConstantFormat::DWord, ConstantFormat::Bytes,
                                            ConstantFormat::LongBytes};

unsigned significantBits(std::uint32_t bits) {
  unsigned width = 0;
  for (; bits; bits >>= 1) ++width;
  return width;
}

}  // namespace

bool tooWide(ConstantFormat format, TypeCode type) {
  return isIn(kStatingWidth, format) && bitWidth(format) > bitWidth(type);
}

std::optional<std::uint32_t> convertConstant(const Constant& constant, TypeCode type) {
  if (tooWide(constant.format, type)) return std::nullopt;
  const auto when = [&](bool fits) {
    return fits ? std::optional<std::uint32_t>(constant.bits) : std::nullopt;
  };
  switch (constant.format) {
    case ConstantFormat::Boolean:
      return when(type == TypeCode::Bool);
    case ConstantFormat::Integer:
    case ConstantFormat::LongInteger: {
      const std::int64_t value = constant.format == ConstantFormat::Integer
                                     ? static_cast<std::int16_t>(constant.bits)
                                     : static_cast<std::int32_t>(constant.bits);
      if (!acceptsInteger(type, value)) return std::nullopt;
      return static_cast<std::uint32_t>(value);
    }
    case ConstantFormat::Real:
      return when(type == TypeCode::Real);
    case ConstantFormat::S5Time:
      return when(type == TypeCode::S5Time || type == TypeCode::Word);
    case ConstantFormat::Time:
      return when(type == TypeCode::Time || type == TypeCode::DWord);
    case ConstantFormat::Date:
      return when(type == TypeCode::Date || type == TypeCode::Word);
    case ConstantFormat::TimeOfDay:
      return when(type == TypeCode::TimeOfDay || type == TypeCode::DWord);
    case ConstantFormat::Counter:
      return when(type == TypeCode::Word || type == TypeCode::Int);
    case ConstantFormat::Characters:
    case ConstantFormat::LongCharacters:
      return when(type == TypeCode::Char   ? constant.bits <= 0xFF
                  : type == TypeCode::Byte ? constant.bits <= 0xFF
                  : type == TypeCode::Word ? constant.bits <= 0xFFFF
                                           : type == TypeCode::DWord);
    case ConstantFormat::Pointer:
      return when(type == TypeCode::DWord || type == TypeCode::DInt);
    case ConstantFormat::Byte:
    case ConstantFormat::Binary:
    case ConstantFormat::Bytes:
    case ConstantFormat::Word:
    case ConstantFormat::LongBinary:
    case ConstantFormat::LongBytes:
    case ConstantFormat::DWord:
      break;
  }
  if (type == TypeCode::Bool) return when(constant.bits <= 1);  // 2#1
  return when(acceptsBits(type, significantBits(constant.bits)));
}

}  // namespace merker::step7
