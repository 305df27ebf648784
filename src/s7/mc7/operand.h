// The operand of a machine instruction, independent of its coding: what compiler, decoder,
// interpreter and printer hand to each other.
#pragma once

#include <cstdint>

#include "address/area.h"
#include "address/block_id.h"
#include "address/constant.h"

namespace merker::mc7 {

enum class OperandKind : std::uint8_t {
  None,
  Memory,          // E 0.0, MW 10, DBX 2.1, PEW 256: area, width, value = bit address
  MemoryIndirect,  // MW [DBD 4]: area, width; pointerArea (Flag, DataBlock, Instance, Local), value
                   // = byte of the pointer
  RegisterIndirect,  // MW [AR1,P#2.0]: area, width, reg 1/2, value = offset as bit address
  RegisterCrossing,  // W [AR1,P#2.0]: width, reg, value = offset as bit address
  Parameter,         // #in of an FC: width, value = index of the parameter (0-based)
  Timer,             // T 5: value = number
  TimerIndirect,     // T [MW 4]: pointerArea, value = byte of the word that holds the number
  TimerParameter,    // #tim of type TIMER: value = index (FC)
  Counter,           // Z 5
  CounterIndirect,   // Z [MW 4]
  CounterParameter,  // #cnt
  StatusBit,         // OV, >0, BIE …: value = StatusQuery
  StatusWord,        // STW
  Constant,          // L 5, L P#M10.0, + 5, UW W#16#1: format, value = bits; anyHeader()
  Pointer,           // +AR1 P#2.0 (16-bit offset): value = bit address
  AddressRegister,   // LAR1 AR2, TAR1 AR2: reg = 2
  ShiftCount,        // SLW 4, INC 5, BLD 130: value
  Jump,      // SPA …: value = signed distance in words from the jump itself (as two's complement)
  JumpList,  // SPL: value = number of entries
  Block,     // UC FC 5, AUF DB 3: block kind in blockKind, value = number; AUF DI: kind DB, reg = 1
  BlockIndirect,     // UC FC [MW 4], AUF DI [LW 2]: blockKind, reg, pointerArea, value
  BlockParameter,    // UC #fc, AUF #db: blockKind, reg, value = index
  ParameterAddress,  // P##param of an FC: value = index
  DataBlockInfo      // L DBLG, DBNO, DILG, DINO: value = DataBlockQuery
};

// Numbers as coded in FF xy (MC7 section 2.1).
enum class StatusQuery : std::uint8_t {
  OS = 0x0,
  OV = 0x1,
  Greater = 0x2,
  Less = 0x4,
  Unordered = 0x5,
  NotEqual = 0x6,
  Equal = 0x8,
  GreaterEqual = 0xA,
  LessEqual = 0xC,
  BIE = 0xE
};

enum class DataBlockQuery : std::uint8_t { DbLength, DiLength, DbNumber, DiNumber };

struct Operand {
  OperandKind kind = OperandKind::None;
  Area area = Area::None;
  Width width = Width::Bit;
  Area pointerArea = Area::None;
  std::uint8_t reg = 0;
  ConstantFormat format = ConstantFormat::Integer;
  BlockKind blockKind = BlockKind::OB;
  std::uint32_t value = 0;
  bool operator==(const Operand&) const = default;
};

// Constructors for the common shapes.
constexpr Operand memory(Area area, Width width, BitAddress address) {
  return {.kind = OperandKind::Memory, .area = area, .width = width, .value = address};
}
constexpr Operand memoryIndirect(Area area, Width width, Area pointerArea, std::uint32_t byte) {
  return {.kind = OperandKind::MemoryIndirect,
          .area = area,
          .width = width,
          .pointerArea = pointerArea,
          .value = byte};
}
constexpr Operand registerIndirect(Area area, Width width, int reg, BitAddress offset) {
  return {.kind = OperandKind::RegisterIndirect,
          .area = area,
          .width = width,
          .reg = static_cast<std::uint8_t>(reg),
          .value = offset};
}
constexpr Operand registerCrossing(Width width, int reg, BitAddress offset) {
  return {.kind = OperandKind::RegisterCrossing,
          .width = width,
          .reg = static_cast<std::uint8_t>(reg),
          .value = offset};
}
constexpr Operand constant(ConstantFormat format, std::uint32_t bits) {
  return {.kind = OperandKind::Constant, .format = format, .value = bits};
}
// The first word of an ANY, a W#16# with a code of its own: ANY#16#1002. It has a width.
constexpr Operand anyHeader(std::uint32_t bits) {
  return {.kind = OperandKind::Constant,
          .width = Width::Word,
          .format = ConstantFormat::Word,
          .value = bits};
}
constexpr bool isAnyHeader(const Operand& operand) {
  return operand.kind == OperandKind::Constant && operand.width == Width::Word;
}
constexpr Operand number(OperandKind kind, std::uint32_t value) {
  return {.kind = kind, .value = value};
}
constexpr Operand blockOperand(BlockKind kind, std::uint32_t number, bool instance = false) {
  return {.kind = OperandKind::Block,
          .reg = static_cast<std::uint8_t>(instance ? 1 : 0),
          .blockKind = kind,
          .value = number};
}

}  // namespace merker::mc7
