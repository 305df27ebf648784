// RLD RRD RLDA RRDA (S7-INSTR-81 … -84).
#include <bit>

#include "interpreter/handlers.h"
#include "interpreter/shift.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

// Whole turns count as one turn (S7-OPEN-49); count 0 does nothing.
template <bool Left, bool FromAccu>
const Op* rotate(cpu::Machine& m, const Op* op) {
  const std::uint32_t count = shiftCount<FromAccu>(m, op);
  if (count == 0) return op + 1;
  std::uint32_t& accu = m.registers.accu[0];
  const int turn = static_cast<int>(count % 32);
  accu = Left ? std::rotl(accu, turn) : std::rotr(accu, turn);
  setShifted(m.registers.status, (Left ? accu & 1 : accu >> 31) != 0);
  return op + 1;
}

// One bit through A1.
const Op* leftThroughA1(cpu::Machine& m, const Op* op) {
  std::uint32_t& accu = m.registers.accu[0];
  const bool out = accu >> 31 != 0;
  accu = accu << 1 | static_cast<std::uint32_t>(m.registers.status.cc1);
  setShifted(m.registers.status, out);
  return op + 1;
}

const Op* rightThroughA1(cpu::Machine& m, const Op* op) {
  std::uint32_t& accu = m.registers.accu[0];
  const bool out = (accu & 1) != 0;
  accu = accu >> 1 | static_cast<std::uint32_t>(m.registers.status.cc1) << 31;
  setShifted(m.registers.status, out);
  return op + 1;
}

}  // namespace

Rows rotateRows() {
  return {{Operation::RLD, Form::None, rotate<true, true>},
          {Operation::RLD, Form::Constant, rotate<true, false>},
          {Operation::RRD, Form::None, rotate<false, true>},
          {Operation::RRD, Form::Constant, rotate<false, false>},
          {Operation::RLDA, Form::None, leftThroughA1},
          {Operation::RRDA, Form::None, rightThroughA1}};
}

}  // namespace merker::interpreter
