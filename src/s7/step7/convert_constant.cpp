// Which constants an elementary type takes.
#include "step7/initial_value.h"

namespace merker::step7 {
namespace {

// Which notations an elementary type takes and how many bits they may need (S7-TYPES, S7-PAR-05).
bool acceptsInteger(TypeCode type, std::int64_t value) {
  switch (type) {
    case TypeCode::Bool:
      return value == 0 || value == 1;
    case TypeCode::Byte:
      return value >= -128 && value <= 255;
    case TypeCode::Word:
    case TypeCode::Int:
    case TypeCode::DWord:
    case TypeCode::DInt:
      return true;  // a number without a format has 16 bits, one with L# is too wide for the first
                    // two
    default:
      return false;
  }
}

bool acceptsBits(TypeCode type, unsigned width) {
  switch (type) {
    case TypeCode::Byte:
    case TypeCode::Char:
      return width <= 8;
    case TypeCode::Word:
    case TypeCode::Int:
    case TypeCode::S5Time:
    case TypeCode::Date:
      return width <= 16;
    case TypeCode::DWord:
    case TypeCode::DInt:
    case TypeCode::Real:
    case TypeCode::Time:
    case TypeCode::TimeOfDay:
      return width <= 32;
    default:
      return false;
  }
}

// L#5, W#16#5, DW#16#5 and B#(1,2) say how wide they are, whatever their value (S7-PAR-05).
bool statesWidth(ConstantFormat format) {
  switch (format) {
    case ConstantFormat::LongInteger:
    case ConstantFormat::Word:
    case ConstantFormat::DWord:
    case ConstantFormat::Bytes:
    case ConstantFormat::LongBytes:
      return true;
    default:
      return false;
  }
}

unsigned significantBits(std::uint32_t bits) {
  unsigned width = 0;
  for (; bits; bits >>= 1) ++width;
  return width;
}

}  // namespace

bool tooWide(ConstantFormat format, TypeCode type) {
  return statesWidth(format) && bitWidth(format) > bitWidth(type);
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
    default:
      break;
  }
  if (type == TypeCode::Bool) return when(constant.bits <= 1);  // 2#1
  return when(acceptsBits(type, significantBits(constant.bits)));
}

}  // namespace merker::step7
