#include "scenario/display.h"

#include <fmt/format.h>

#include <bit>

#include "address/constant.h"
#include "base/bcd.h"
#include "scenario/long_value.h"

namespace merker::simulator {
namespace {

using address::OperandKind;

ConstantFormat plainFormat(Width width) {
  return width == Width::Byte   ? ConstantFormat::Byte
         : width == Width::Word ? ConstantFormat::Word
                                : ConstantFormat::DWord;
}

TypeCode typeOf(const address::Reference& reference) {
  if (reference.operand.kind == OperandKind::Timer) return TypeCode::S5Time;
  if (reference.operand.kind == OperandKind::Counter) return TypeCode::Counter;
  return reference.type;
}

std::int64_t s5TimeMilliseconds(std::uint32_t bits) {
  return decodeS5Time(static_cast<std::uint16_t>(bits)).value_or(0);
}

// With the shortest base, whatever base the timer counts with.
std::string formatTimer(std::uint32_t bits) {
  const auto coded = encodeS5Time(static_cast<std::uint64_t>(s5TimeMilliseconds(bits)));
  return formatConstant({ConstantFormat::S5Time, coded.value_or(0)});
}

}  // namespace

bool isStep5Cell(const address::Reference& reference) {
  const OperandKind kind = reference.operand.kind;
  return (kind == OperandKind::Timer || kind == OperandKind::Counter) &&
         reference.type == TypeCode::Word;
}

std::string formatTimeConstant(std::uint32_t bits) {
  return fmt::format("KT {:x}.{}", bits & 0xFFF, bits >> 12 & 3);
}

std::string formatCountConstant(std::uint32_t bits) { return fmt::format("KZ {:x}", bits & 0xFFF); }

std::string formatOperand(const address::Reference& reference, std::uint32_t bits) {
  const TypeCode type = typeOf(reference);
  if (bitWidth(reference) == 1) return bits != 0 ? "1" : "0";
  if (isStep5Cell(reference))
    return reference.operand.kind == OperandKind::Timer ? formatTimeConstant(bits)
                                                        : formatCountConstant(bits);
  if (reference.operand.kind == OperandKind::Timer) return formatTimer(bits);
  if (type == TypeCode::Counter) return formatConstant({ConstantFormat::Counter, bits});
  if (isElementary(type)) return formatValue(type, bits);
  return formatConstant({plainFormat(reference.operand.width), bits});
}

std::optional<std::string> show(const address::Reference& reference,
                                const controller::Controller& plc) {
  if (isLong(reference)) {
    const auto content = readLong(reference, plc);
    return content ? std::optional(formatLong(reference.type, *content)) : std::nullopt;
  }
  const auto bits = plc.read(reference);
  return bits ? std::optional(formatOperand(reference, *bits)) : std::nullopt;
}

std::variant<bool, std::int64_t, double> numericValue(const address::Reference& reference,
                                                      std::uint32_t bits) {
  if (bitWidth(reference) == 1) return bits != 0;
  switch (typeOf(reference)) {
    case TypeCode::Int:
      return std::int64_t{static_cast<std::int16_t>(bits)};
    case TypeCode::DInt:
    case TypeCode::Time:
      return std::int64_t{static_cast<std::int32_t>(bits)};
    case TypeCode::Real:
      return double{std::bit_cast<float>(bits)};
    case TypeCode::S5Time:
      return s5TimeMilliseconds(bits);
    case TypeCode::Counter:
      return std::int64_t{fromBcd(bits & 0xFFF, 3).value_or(0)};
    case TypeCode::Void:
    case TypeCode::Bool:
    case TypeCode::Byte:
    case TypeCode::Char:
    case TypeCode::Word:
    case TypeCode::DWord:
    case TypeCode::Date:
    case TypeCode::TimeOfDay:
    case TypeCode::DateAndTime:
    case TypeCode::Array:
    case TypeCode::Struct:
    case TypeCode::String:
    case TypeCode::Pointer:
    case TypeCode::FunctionBlock:
    case TypeCode::Any:
    case TypeCode::BlockFb:
    case TypeCode::BlockFc:
    case TypeCode::BlockDb:
    case TypeCode::BlockSdb:
    case TypeCode::SystemFunctionBlock:
    case TypeCode::Timer:
      break;
  }
  return std::int64_t{bits};
}

}  // namespace merker::simulator
