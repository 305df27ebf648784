// What shifts and rotations share.
#pragma once

#include "interpreter/op.h"

namespace merker::interpreter {

// The count stands in the instruction, or in AKKU2-LL (0 … 255).
template <bool FromAccu>
std::uint32_t shiftCount(const cpu::Machine& m, const Op* op) {
  return FromAccu ? m.registers.accu[1] & 0xFF : op->value;
}

// A1 = last bit shifted out, A0 and OV 0 (S7-STW-12).
inline void setShifted(cpu::StatusWord& s, bool last) {
  s.cc1 = last;
  s.cc0 = s.ov = false;
}

}  // namespace merker::interpreter
