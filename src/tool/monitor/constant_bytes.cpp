#include "monitor/constant_bytes.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;
using mc7::Operation;

bool isMemory(const mc7::Operand& operand, Area area) {
  const bool direct = operand.kind == OperandKind::Memory;
  const bool byAr2 = operand.kind == OperandKind::RegisterIndirect && operand.reg == 2;
  return operand.area == area && operand.width != Width::Bit && (direct || byAr2);
}

}  // namespace

void ConstantBytes::load(const mc7::Operand& operand) {
  if (operand.kind == OperandKind::Constant)
    accu_ = operand.value;
  else if (isMemory(operand, Area::Local))
    accu_ = value(Area::Local, operand.value, operand.width);
  else
    accu_.reset();
}

void ConstantBytes::transfer(const mc7::Operand& operand) {
  if (!isMemory(operand, Area::Local) && !isMemory(operand, Area::Instance)) return;
  Bytes& bytes = operand.area == Area::Local ? local_ : instance_;
  const std::uint32_t count = byteCount(operand.width), first = operand.value / 8;
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes.erase(first + i);
    if (accu_) bytes[first + i] = static_cast<std::uint8_t>(*accu_ >> 8 * (count - 1 - i));
  }
}

void ConstantBytes::executed(const mc7::Instruction& one) {
  if (one.operation == Operation::TRANSFER) return transfer(one.operand);
  if (one.operation == Operation::LOAD) return load(one.operand);
  if (one.operation == Operation::ADD_AR2 && one.operand.kind == OperandKind::Pointer)
    shift_ = one.operand.value / 8;
  if (one.operation == Operation::LAR2) shift_ = 0;  // an address in the own instance was made
  accu_.reset();
}

std::optional<std::uint32_t> ConstantBytes::value(Area area, BitAddress at, Width width) const {
  const Bytes& bytes = area == Area::Instance ? instance_ : local_;
  const std::uint32_t first = at / 8 + (area == Area::Instance ? shift_ : 0);
  std::uint32_t result = 0;
  for (std::uint32_t i = 0; i < byteCount(width); ++i) {
    const auto found = bytes.find(first + i);
    if (found == bytes.end()) return std::nullopt;
    result = result << 8 | found->second;
  }
  return result;
}

std::optional<Descriptor> ConstantBytes::pointer(Area area, BitAddress at) const {
  const auto db = value(area, at, Width::Word);
  const auto where = value(area, at + bitAddress(2), Width::DWord);
  if (!db || !where) return std::nullopt;
  return Descriptor{.db = static_cast<std::uint16_t>(*db), .pointer = *where};
}

std::optional<Descriptor> ConstantBytes::any(Area area, BitAddress at) const {
  const auto type = value(area, at, Width::Word);
  const auto count = value(area, at + bitAddress(2), Width::Word);
  auto result = pointer(area, at + bitAddress(4));
  if (!type || !count || !result) return std::nullopt;
  result->type = static_cast<TypeCode>(*type & 0xFF);
  result->count = *count;
  return result;
}

}  // namespace merker::monitor
