#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using cpu::Access;
using cpu::ErrorCode;
using cpu::SyncError;
using mc7::OperandKind;

SyncError areaError(Access access, Width width, std::uint32_t detail) {
  const ErrorCode code = access == Access::Read ? ErrorCode::AreaRead : ErrorCode::AreaWrite;
  return {.code = code, .area = Area::None, .width = width, .detail = detail};
}

bool validArea(Area area) { return area >= Area::Peripheral && area <= Area::CallerLocal; }

// [MD n]: bits 18..0 of the double word (S7-IND-03).
Effective memoryIndirect(cpu::Machine& m, const Op* op) {
  std::uint32_t pointer = 0;
  const SyncError error =
      cpu::read(m, op->pointerArea, Width::DWord, bitAddress(op->value), pointer);
  return {.area = op->area, .address = pointerAddress(pointer), .error = error};
}

// [AR1,P#n]: what lies above bit 18 lies outside every area (S7-IND-05).
Effective registerIndirect(cpu::Machine& m, const Op* op) {
  const std::uint32_t ar = op->reg == 2 ? m.registers.ar2 : m.registers.ar1;
  return {.area = op->area, .address = (ar & 0xFFFFFF) + op->value};
}

// The area stands in the register (S7-IND-06).
Effective registerCrossing(cpu::Machine& m, const Op* op, Access access) {
  const std::uint32_t ar = op->reg == 2 ? m.registers.ar2 : m.registers.ar1;
  Effective result{.area = pointerArea(ar), .address = (ar & 0xFFFFFF) + op->value};
  if (!validArea(result.area)) result.error = areaError(access, op->width, result.address / 8);
  return result;
}

// The pointer in the list behind the call (S7-PAR-01, MC7 section 7.2).
Effective parameter(cpu::Machine& m, const Op* op, Access access) {
  if (op->value >= m.top->parameterCount) return {.error = areaError(access, op->width, op->value)};
  const std::uint32_t pointer = m.top->parameters[op->value];
  Effective result{.area = pointerArea(pointer), .address = pointerAddress(pointer)};
  if (!validArea(result.area)) result.error = areaError(access, op->width, result.address / 8);
  return result;
}

}  // namespace

Effective effective(cpu::Machine& m, const Op* op, Access access) {
  switch (op->kind) {
    case OperandKind::MemoryIndirect:
      return memoryIndirect(m, op);
    case OperandKind::RegisterIndirect:
      return registerIndirect(m, op);
    case OperandKind::RegisterCrossing:
      return registerCrossing(m, op, access);
    case OperandKind::Parameter:
      return parameter(m, op, access);
    default:
      return {.area = op->area, .address = op->value};
  }
}

SyncError readOperand(cpu::Machine& m, const Op* op, Width width, std::uint32_t& value) {
  value = 0;
  const Effective place = effective(m, op, Access::Read);
  return place.error ? place.error : cpu::read(m, place.area, width, place.address, value);
}

SyncError writeOperand(cpu::Machine& m, const Op* op, Width width, std::uint32_t value) {
  const Effective place = effective(m, op, Access::Write);
  return place.error ? place.error : cpu::write(m, place.area, width, place.address, value);
}

cpu::Located locateOperand(cpu::Machine& m, const Op* op, Width width, Access access) {
  const Effective place = effective(m, op, access);
  if (place.error) return {.error = place.error};
  return cpu::locate(m, place.area, width, place.address, access);
}

SyncError numberOperand(cpu::Machine& m, const Op* op, std::uint32_t& number) {
  switch (op->kind) {
    case OperandKind::TimerIndirect:
    case OperandKind::CounterIndirect:
    case OperandKind::BlockIndirect:
      return cpu::read(m, op->pointerArea, Width::Word, bitAddress(op->value), number);
    case OperandKind::TimerParameter:
    case OperandKind::CounterParameter:
    case OperandKind::BlockParameter:
      if (op->value >= m.top->parameterCount)
        return areaError(Access::Read, Width::Word, op->value);
      number = m.top->parameters[op->value] >> 16;
      return {};
    default:
      number = op->value;
      return {};
  }
}

}  // namespace merker::interpreter
