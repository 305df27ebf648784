#include "cnc/reference.h"

#include <charconv>

#include "nc/datum.h"
#include "step5/variable.h"

namespace merker::cnc {
namespace {

using From = mc5::Width;

Width plainWidth(From width) {
  switch (width) {
    case From::Bit:
      return Width::Bit;
    case From::Byte:
    case From::Left:
    case From::Right:
      return Width::Byte;
    case From::Word:
      return Width::Word;
    case From::Double:
      return Width::DWord;
  }
  return Width::Word;
}

From plainWidth(Width width) {
  switch (width) {
    case Width::Bit:
      return From::Bit;
    case Width::Byte:
      return From::Byte;
    case Width::Word:
      return From::Word;
    case Width::DWord:
      return From::Double;
  }
  return From::Word;
}

struct AreaPair {
  mc5::Area step5;
  Area area;
};
constexpr AreaPair kAreas[] = {{mc5::Area::Input, Area::Input},
                               {mc5::Area::Output, Area::Output},
                               {mc5::Area::Flag, Area::Flag},
                               {mc5::Area::Peripheral, Area::Peripheral},
                               {mc5::Area::Data, Area::DataBlock}};

// Bits 8..15 of a data word are in its left byte (S5-BLK-10).
BitAddress dataAddress(const mc5::Operand& operand) {
  const std::uint32_t left = operand.value * 2;
  if (operand.width == From::Right) return bitAddress(left + 1);
  if (operand.width != From::Bit) return bitAddress(left);
  return operand.bit >= 8 ? bitAddress(left, operand.bit - 8u) : bitAddress(left + 1, operand.bit);
}

std::optional<mc5::Operand> dataOperand(const mc7::Operand& operand) {
  const std::uint32_t byte = operand.value / 8, word = byte / 2;
  const bool right = byte % 2 != 0;
  mc5::Operand result{.kind = mc5::OperandKind::Memory,
                      .area = mc5::Area::Data,
                      .width = plainWidth(operand.width),
                      .value = word};
  if (operand.width == Width::Byte) result.width = right ? From::Right : From::Left;
  if (operand.width == Width::Bit)
    result.bit = static_cast<std::uint8_t>(operand.value % 8 + (right ? 0 : 8));
  else if (operand.width != Width::Byte && right)
    return std::nullopt;
  return result;
}

ConstantFormat formatOf(mc5::Format format) {
  switch (format) {
    case mc5::Format::Byte:
    case mc5::Format::SignedByte:
      return ConstantFormat::Byte;
    case mc5::Format::Fixed:
      return ConstantFormat::Integer;
    case mc5::Format::Float:
      return ConstantFormat::DWord;
    case mc5::Format::Time:  // base and three digits, as those of S5T#
      return ConstantFormat::S5Time;
    case mc5::Format::Counter:
      return ConstantFormat::Counter;
    default:
      return ConstantFormat::Word;
  }
}

// Whole numbers beyond 16 bits need no L# here: data double words of STEP 5 have no type.
std::optional<Constant> longInteger(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || (value >= INT16_MIN && value <= INT16_MAX)) return std::nullopt;
  if (value < INT32_MIN || value > UINT32_MAX) return std::nullopt;
  return Constant{ConstantFormat::LongInteger, static_cast<std::uint32_t>(value)};
}

mc7::Operand cell(const mc5::Operand& operand) {
  mc7::Operand result;
  result.kind =
      operand.kind == mc5::OperandKind::Timer ? mc7::OperandKind::Timer : mc7::OperandKind::Counter;
  result.width = Width::Word;
  result.value = operand.value;
  return result;
}

mc7::Operand memory(const mc5::Operand& operand) {
  for (const AreaPair& pair : kAreas) {
    if (pair.step5 != operand.area) continue;
    const BitAddress address = operand.area == mc5::Area::Data
                                   ? dataAddress(operand)
                                   : bitAddress(operand.value, operand.bit);
    return mc7::memory(pair.area, plainWidth(operand.width), address);
  }
  return {};
}

std::optional<mc5::Operand> memory(const mc7::Operand& operand) {
  if (operand.area == Area::DataBlock) return dataOperand(operand);
  for (const AreaPair& pair : kAreas)
    if (pair.area == operand.area)
      return mc5::Operand{.kind = mc5::OperandKind::Memory,
                          .area = pair.step5,
                          .width = plainWidth(operand.width),
                          .bit = static_cast<std::uint8_t>(operand.value % 8),
                          .value = operand.value / 8};
  return std::nullopt;
}

}  // namespace

mc7::Reference toReference(std::string_view text, const mc5::Variable& variable) {
  mc7::Reference reference;
  reference.text = text;
  const bool isMemory = variable.operand.kind == mc5::OperandKind::Memory;
  reference.operand = isMemory ? memory(variable.operand) : cell(variable.operand);
  if (reference.operand.area == Area::DataBlock) reference.db = variable.dataBlock;
  if (!isMemory) reference.type = TypeCode::Word;  // what LC loads, base included
  return reference;
}

std::optional<mc7::Reference> datumReference(std::string_view text) {
  const auto datum = nc::parseDatum(text);
  if (!datum) return std::nullopt;
  mc7::Reference reference;
  reference.text = text;
  reference.operand.kind = mc7::OperandKind::Memory;
  reference.nc = nc::pack(*datum);
  return reference;
}

std::optional<Constant> parseConstant(std::string_view text) {
  const auto operand = step5::parseConstant(text);
  if (!operand) return longInteger(text);
  return Constant{formatOf(operand->format), operand->value};
}

std::optional<mc5::Variable> toVariable(const mc7::Reference& reference) {
  const mc7::Operand& operand = reference.operand;
  if (operand.kind == mc7::OperandKind::Timer || operand.kind == mc7::OperandKind::Counter) {
    const bool timer = operand.kind == mc7::OperandKind::Timer;
    return mc5::Variable{{.kind = timer ? mc5::OperandKind::Timer : mc5::OperandKind::Counter,
                          .width = operand.width == Width::Bit ? From::Bit : From::Word,
                          .value = operand.value},
                         0};
  }
  if (operand.kind != mc7::OperandKind::Memory) return std::nullopt;
  const auto value = memory(operand);
  if (!value) return std::nullopt;
  return mc5::Variable{*value, static_cast<std::uint16_t>(reference.db < 0 ? 0 : reference.db)};
}

}  // namespace merker::cnc
