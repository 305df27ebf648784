// A value of a PLC that someone outside its program looks at, in the words of no family: what
// scenarios, traces, watch lists and forces speak. A text becomes a reference once, in the compiler
// of its family (step7/compiler.h, step5/variable.h).
#pragma once

#include <cstdint>
#include <string>

#include "address/area.h"
#include "address/type_code.h"

namespace merker::address {

enum class OperandKind : std::uint8_t {
  None,
  Memory,  // E 0.0, MW 10, DBX 2.1, DW 5, PEW 256: area, width, value = bit address
  Timer,   // T 5: value = number; width Bit: its status, Word: what LC loads
  Counter  // Z 5
};

// A data word of STEP 5 is two bytes, the left one first: DW 5 is the word at byte 10, D 5.8 bit 0
// of byte 10 (S5-BLK-10).
struct Operand {
  OperandKind kind = OperandKind::None;
  Area area = Area::None;
  Width width = Width::Bit;
  std::uint32_t value = 0;
  bool operator==(const Operand&) const = default;
};

constexpr Operand memory(Area area, Width width, BitAddress address) {
  return {.kind = OperandKind::Memory, .area = area, .width = width, .value = address};
}

constexpr Operand timer(std::uint32_t number) {
  return {.kind = OperandKind::Timer, .value = number};
}
constexpr Operand counter(std::uint32_t number) {
  return {.kind = OperandKind::Counter, .value = number};
}

struct Reference {
  std::string text;                // as the user wrote it
  Operand operand;                 // area DataBlock together with `db`
  std::int32_t db = -1;            // number of the data block, -1 outside of data blocks
  TypeCode type = TypeCode::Void;  // of a typed variable or symbol; Void for an absolute operand
  bool outputSide = false;         // of the periphery: PA, else PE
  std::uint32_t bytes = 0;  // of a DATE_AND_TIME or STRING, which no `operand.width` holds; else 0
  std::uint32_t nc = 0;     // a datum of the NC of a SINUMERIK, packed (nc/datum.h); else 0
  bool partner = false;     // of the control that is coupled with this one
  std::uint16_t station =
      0;  // of a project of several: counted from 1; 0: of the PLC that is asked
};

constexpr bool isTimer(const Operand& operand) { return operand.kind == OperandKind::Timer; }
constexpr bool isCounter(const Operand& operand) { return operand.kind == OperandKind::Counter; }
constexpr bool isMemory(const Operand& operand) { return operand.kind == OperandKind::Memory; }

}  // namespace merker::address
