// SLW SLD SRW SRD SSI SSD (S7-INSTR-75 … -80). Count 0 does nothing at all, not even to the status
// word.
#include "interpreter/shift.h"

#include <algorithm>

#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

template <unsigned Bits>
void setResult(cpu::Machine& m, std::uint64_t result) {
  if constexpr (Bits == 16)
    m.registers.setLow(static_cast<std::uint32_t>(result));
  else
    m.registers.accu[0] = static_cast<std::uint32_t>(result);
}

template <unsigned Bits>
std::uint64_t value(const cpu::Machine& m) {
  return Bits == 16 ? m.registers.low(0) : m.registers.accu[0];
}

// The value stands at the bottom of 64 bits: what leaves it upwards is still there to look at.
template <unsigned Bits, bool FromAccu>
const Op* left(cpu::Machine& m, const Op* op) {
  const std::uint32_t count = shiftCount<FromAccu>(m, op);
  if (count == 0) return op + 1;
  const std::uint64_t shifted = count > Bits ? 0 : value<Bits>(m) << count;
  setResult<Bits>(m, shifted);
  setShifted(m.registers.status, (shifted >> Bits & 1) != 0);
  return op + 1;
}

template <unsigned Bits, bool FromAccu>
const Op* right(cpu::Machine& m, const Op* op) {
  const std::uint32_t count = shiftCount<FromAccu>(m, op);
  if (count == 0) return op + 1;
  const std::uint64_t before = count > Bits ? 0 : value<Bits>(m);
  setShifted(m.registers.status, (before >> (std::min(count, Bits) - 1) & 1) != 0);
  setResult<Bits>(m, before >> std::min(count, Bits));
  return op + 1;
}

// The sign fills up; more than all bits acts as all bits.
template <unsigned Bits, bool FromAccu>
const Op* rightSigned(cpu::Machine& m, const Op* op) {
  const std::uint32_t count = std::min(shiftCount<FromAccu>(m, op), Bits);
  if (count == 0) return op + 1;
  const std::int64_t before = Bits == 16 ? static_cast<std::int16_t>(m.registers.low(0))
                                         : static_cast<std::int32_t>(m.registers.accu[0]);
  setShifted(m.registers.status, (before >> (count - 1) & 1) != 0);
  setResult<Bits>(m, static_cast<std::uint64_t>(before >> count));
  return op + 1;
}

}  // namespace

Rows shiftRows() {
  return {{Operation::SLW, Form::None, left<16, true>},
          {Operation::SLW, Form::Constant, left<16, false>},
          {Operation::SLD, Form::None, left<32, true>},
          {Operation::SLD, Form::Constant, left<32, false>},
          {Operation::SRW, Form::None, right<16, true>},
          {Operation::SRW, Form::Constant, right<16, false>},
          {Operation::SRD, Form::None, right<32, true>},
          {Operation::SRD, Form::Constant, right<32, false>},
          {Operation::SSI, Form::None, rightSigned<16, true>},
          {Operation::SSI, Form::Constant, rightSigned<16, false>},
          {Operation::SSD, Form::None, rightSigned<32, true>},
          {Operation::SSD, Form::Constant, rightSigned<32, false>}};
}

}  // namespace merker::interpreter
