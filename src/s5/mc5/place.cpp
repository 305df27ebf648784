#include "mc5/place.h"

namespace merker::mc5 {
namespace {

constexpr merker::Area areaOf(Area area) {
  switch (area) {
    case Area::Input:
      return merker::Area::Input;
    case Area::Output:
      return merker::Area::Output;
    case Area::Flag:
      return merker::Area::Flag;
    case Area::Data:
      return merker::Area::DataBlock;
    case Area::Peripheral:
      return merker::Area::Peripheral;
    case Area::None:
      break;
  }
  return merker::Area::None;
}

constexpr merker::Width widthOf(Width width) {
  switch (width) {
    case Width::Bit:
      return merker::Width::Bit;
    case Width::Byte:
    case Width::Left:
    case Width::Right:
      return merker::Width::Byte;
    case Width::Word:
      return merker::Width::Word;
    case Width::Double:
      return merker::Width::DWord;
  }
  return merker::Width::Word;
}

// Bits 8..15 of a data word are in its left byte (S5-BLK-10).
constexpr BitAddress dataAddress(const Operand& operand) {
  const std::uint32_t left = operand.value * 2;
  if (operand.width == Width::Right) return bitAddress(left + 1);
  if (operand.width != Width::Bit) return bitAddress(left);
  return operand.bit >= 8 ? bitAddress(left, operand.bit - 8u) : bitAddress(left + 1, operand.bit);
}

// Without a bit: what LC loads, the time base included.
constexpr address::Operand cell(address::OperandKind kind, const Operand& operand) {
  const bool bit = operand.width == Width::Bit;
  return {kind, merker::Area::None, bit ? merker::Width::Bit : merker::Width::Word, operand.value};
}

}  // namespace

address::Operand placeOf(const Operand& operand) {
  if (operand.kind == OperandKind::Timer) return cell(address::OperandKind::Timer, operand);
  if (operand.kind == OperandKind::Counter) return cell(address::OperandKind::Counter, operand);
  const unsigned lastBit = operand.area == Area::Data ? 15 : 7;
  if (operand.kind != OperandKind::Memory || operand.bit > lastBit) return {};
  const BitAddress at =
      operand.area == Area::Data ? dataAddress(operand) : bitAddress(operand.value, operand.bit);
  return address::memory(areaOf(operand.area), widthOf(operand.width), at);
}

}  // namespace merker::mc5
