// REAL as the accumulators hold it: IEEE 754 single, and the status bits of a result.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "interpreter/arithmetic.h"

namespace merker::interpreter {

inline float real(const cpu::Machine& m, unsigned accu) {
  return std::bit_cast<float>(m.registers.accu[accu]);
}

// Result to AKKU1 with A1 A0 OV OS (S7-INSTR-60). A result that is no number has one fixed pattern,
// so that it does not depend on the host.
inline void setReal(cpu::Machine& m, float result) {
  constexpr std::uint32_t kNoNumber = 0xFFFF'FFFF;
  cpu::StatusWord& s = m.registers.status;
  switch (std::fpclassify(result)) {
    case FP_NAN:
      m.registers.accu[0] = kNoNumber;
      return setInvalid(s);
    case FP_SUBNORMAL:  // underflow: 00 with OV (S7-OPEN-48)
      m.registers.accu[0] = std::bit_cast<std::uint32_t>(result);
      s.cc0 = s.cc1 = false;
      return setOverflow(s, true);
    case FP_INFINITE:
      m.registers.accu[0] = std::bit_cast<std::uint32_t>(result);
      s.setSign(result);
      return setOverflow(s, true);
    default:
      m.registers.accu[0] = std::bit_cast<std::uint32_t>(result);
      s.setSign(result);
      return setOverflow(s, false);
  }
}

}  // namespace merker::interpreter
