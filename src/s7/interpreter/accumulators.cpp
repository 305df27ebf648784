// TAW TAD TAK PUSH POP ENT LEAVE INC DEC BLD NOP (S7-INSTR-85 … -91).
#include <utility>

#include "interpreter/fault.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

const Op* swapBytes(cpu::Machine& m, const Op* op) {
  const std::uint32_t low = m.registers.low(0);
  m.registers.setLow(low << 8 | low >> 8);
  return op + 1;
}

const Op* reverseBytes(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] = __builtin_bswap32(m.registers.accu[0]);
  return op + 1;
}

const Op* exchange(cpu::Machine& m, const Op* op) {
  std::swap(m.registers.accu[0], m.registers.accu[1]);
  return op + 1;
}

const Op* push(cpu::Machine& m, const Op* op) {
  auto& accu = m.registers.accu;
  if (m.fourAccumulators) {
    accu[3] = accu[2];
    accu[2] = accu[1];
  }
  accu[1] = accu[0];
  return op + 1;
}

const Op* pop(cpu::Machine& m, const Op* op) {
  auto& accu = m.registers.accu;
  accu[0] = accu[1];
  if (m.fourAccumulators) {
    accu[1] = accu[2];
    accu[2] = accu[3];
  }
  return op + 1;
}

// Only CPUs with four accumulators know ENT and LEAVE (S7-OPEN-12).
const Op* enter(cpu::Machine& m, const Op* op) {
  if (!m.fourAccumulators) return unknownCode(m, op);
  m.registers.accu[3] = m.registers.accu[2];
  m.registers.accu[2] = m.registers.accu[1];
  return op + 1;
}

const Op* leave(cpu::Machine& m, const Op* op) {
  if (!m.fourAccumulators) return unknownCode(m, op);
  m.registers.accu[1] = m.registers.accu[2];
  m.registers.accu[2] = m.registers.accu[3];
  return op + 1;
}

// AKKU1-LL only.
template <bool Up>
const Op* step(cpu::Machine& m, const Op* op) {
  std::uint32_t& accu = m.registers.accu[0];
  accu = (accu & 0xFFFF'FF00u) | ((Up ? accu + op->value : accu - op->value) & 0xFF);
  return op + 1;
}

const Op* nothing(cpu::Machine&, const Op* op) { return op + 1; }

}  // namespace

Rows accumulatorRows() {
  return {{Operation::SWAP_BYTES_W, Form::None, swapBytes},
          {Operation::SWAP_BYTES_D, Form::None, reverseBytes},
          {Operation::TAK, Form::None, exchange},
          {Operation::PUSH, Form::None, push},
          {Operation::POP, Form::None, pop},
          {Operation::ENT, Form::None, enter},
          {Operation::LEAVE, Form::None, leave},
          {Operation::INC, Form::Constant, step<true>},
          {Operation::DEC, Form::Constant, step<false>},
          {Operation::BLD, Form::Constant, nothing},
          {Operation::BLD, Form::None, nothing},
          {Operation::NOP0, Form::None, nothing},
          {Operation::NOP1, Form::None, nothing}};
}

}  // namespace merker::interpreter
