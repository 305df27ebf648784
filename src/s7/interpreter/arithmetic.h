// What arithmetic instructions share: status bits and the upper accumulators.
#pragma once

#include <cstdint>

#include "cpu/machine.h"

namespace merker::interpreter {

// OV as told; OS keeps an earlier overflow (S7-STW-06, -07).
inline void setOverflow(cpu::StatusWord& s, bool overflow) {
  s.ov = overflow;
  s.os = s.os || overflow;
}

// A1 A0 = 11 with OV: division by zero, no number (S7-STW-10).
inline void setInvalid(cpu::StatusWord& s) {
  s.cc0 = s.cc1 = true;
  setOverflow(s, true);
}

// CPUs with four accumulators: an operation on two operands lets accumulators 3 and 4 move down.
inline void dropOperand(cpu::Machine& m) {
  if (!m.fourAccumulators) return;
  m.registers.accu[1] = m.registers.accu[2];
  m.registers.accu[2] = m.registers.accu[3];
}

}  // namespace merker::interpreter
