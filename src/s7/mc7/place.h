// Operands of machine instructions as places that both families name, and back.
#pragma once

#include "address/reference.h"
#include "mc7/operand.h"

namespace merker::mc7 {

// Kind None for what has no fixed place: constants, indirect operands, parameters, blocks.
constexpr address::Operand placeOf(const Operand& operand) {
  if (operand.kind == OperandKind::Memory)
    return address::memory(operand.area, operand.width, operand.value);
  if (operand.kind == OperandKind::Timer)
    return {address::OperandKind::Timer, Area::None, operand.width, operand.value};
  if (operand.kind == OperandKind::Counter)
    return {address::OperandKind::Counter, Area::None, operand.width, operand.value};
  return {};
}

constexpr Operand operandAt(const address::Operand& place) {
  switch (place.kind) {
    case address::OperandKind::Memory:
      return memory(place.area, place.width, place.value);
    case address::OperandKind::Timer:
      return {.kind = OperandKind::Timer, .width = place.width, .value = place.value};
    case address::OperandKind::Counter:
      return {.kind = OperandKind::Counter, .width = place.width, .value = place.value};
    case address::OperandKind::None:
      break;
  }
  return {};
}

}  // namespace merker::mc7
