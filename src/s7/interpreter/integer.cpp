// +I -I *I /I, + constant, NEGI INVI (S7-INSTR-51 … -54, -71, -102, -103).
#include "interpreter/arithmetic.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

constexpr bool fits(std::int32_t value) { return value >= INT16_MIN && value <= INT16_MAX; }
std::int32_t operand(const cpu::Machine& m, unsigned accu) {
  return static_cast<std::int16_t>(m.registers.low(accu));
}

// The result wraps; A1 A0 are those of the wrapped number (S7-STW-10: 32767 + 1 gives 01).
void wrap(cpu::Machine& m, std::int32_t exact) {
  m.registers.setLow(static_cast<std::uint32_t>(exact));
  m.registers.status.setSign(static_cast<std::int16_t>(exact));
  setOverflow(m.registers.status, !fits(exact));
}

const Op* plus(cpu::Machine& m, const Op* op) {
  wrap(m, operand(m, 1) + operand(m, 0));
  dropOperand(m);
  return op + 1;
}

const Op* minus(cpu::Machine& m, const Op* op) {
  wrap(m, operand(m, 1) - operand(m, 0));
  dropOperand(m);
  return op + 1;
}

// 32-bit product, never wrong; OV says that it is no INT.
const Op* times(cpu::Machine& m, const Op* op) {
  const std::int32_t product = operand(m, 1) * operand(m, 0);
  m.registers.accu[0] = static_cast<std::uint32_t>(product);
  m.registers.status.setSign(product);
  setOverflow(m.registers.status, !fits(product));
  dropOperand(m);
  return op + 1;
}

// Quotient low, remainder high.
const Op* divide(cpu::Machine& m, const Op* op) {
  const std::int32_t dividend = operand(m, 1), divisor = operand(m, 0);
  if (divisor == 0) {
    setInvalid(m.registers.status);
  } else {
    const std::int32_t quotient = dividend / divisor, remainder = dividend % divisor;
    m.registers.accu[0] = static_cast<std::uint32_t>(remainder) << 16 |
                          (static_cast<std::uint32_t>(quotient) & 0xFFFF);
    m.registers.status.setSign(quotient);
    setOverflow(m.registers.status, !fits(quotient));
  }
  dropOperand(m);
  return op + 1;
}

// No carry into the high word, no status bits (S7-INSTR-71); L#… adds to all 32 bits.
const Op* addConstant(cpu::Machine& m, const Op* op) {
  m.registers.setLow(m.registers.accu[0] + op->value);
  return op + 1;
}
const Op* addLongConstant(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] += op->value;
  return op + 1;
}

const Op* negate(cpu::Machine& m, const Op* op) {
  wrap(m, -operand(m, 0));
  return op + 1;
}

const Op* invert(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] ^= 0xFFFF;
  return op + 1;
}

}  // namespace

Rows integerRows() {
  return {{Operation::ADD_I, Form::None, plus},
          {Operation::SUB_I, Form::None, minus},
          {Operation::MUL_I, Form::None, times},
          {Operation::DIV_I, Form::None, divide},
          {Operation::ADD_CONSTANT, Form::Constant, addConstant},
          {Operation::ADD_CONSTANT, Form::Constant, addLongConstant, Width::DWord},
          {Operation::NEGI, Form::None, negate},
          {Operation::INVI, Form::None, invert}};
}

}  // namespace merker::interpreter
