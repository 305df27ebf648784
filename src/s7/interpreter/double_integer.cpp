// +D -D *D /D MOD, NEGD INVD (S7-INSTR-55 … -59, -102, -104).
#include "interpreter/arithmetic.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

constexpr bool fits(std::int64_t value) { return value >= INT32_MIN && value <= INT32_MAX; }
std::int64_t operand(const cpu::Machine& m, unsigned accu) {
  return static_cast<std::int32_t>(m.registers.accu[accu]);
}

void wrap(cpu::Machine& m, std::int64_t exact) {
  m.registers.accu[0] = static_cast<std::uint32_t>(exact);
  m.registers.status.setSign(static_cast<std::int32_t>(exact));
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

// A1 A0 by the sign of the true product, also when it overflows.
void setExact(cpu::Machine& m, std::int64_t exact) {
  m.registers.accu[0] = static_cast<std::uint32_t>(exact);
  m.registers.status.setSign(exact);
  setOverflow(m.registers.status, !fits(exact));
}

const Op* times(cpu::Machine& m, const Op* op) {
  setExact(m, operand(m, 1) * operand(m, 0));
  dropOperand(m);
  return op + 1;
}

const Op* divide(cpu::Machine& m, const Op* op) {
  const std::int64_t divisor = operand(m, 0);
  if (divisor == 0)
    setInvalid(m.registers.status);
  else
    setExact(m, operand(m, 1) / divisor);
  dropOperand(m);
  return op + 1;
}

const Op* modulo(cpu::Machine& m, const Op* op) {
  const std::int64_t divisor = operand(m, 0);
  if (divisor == 0)
    setInvalid(m.registers.status);
  else
    setExact(m, operand(m, 1) % divisor);
  dropOperand(m);
  return op + 1;
}

const Op* negate(cpu::Machine& m, const Op* op) {
  wrap(m, -operand(m, 0));
  return op + 1;
}

const Op* invert(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] = ~m.registers.accu[0];
  return op + 1;
}

}  // namespace

Rows doubleIntegerRows() {
  return {{Operation::ADD_D, Form::None, plus},  {Operation::SUB_D, Form::None, minus},
          {Operation::MUL_D, Form::None, times}, {Operation::DIV_D, Form::None, divide},
          {Operation::MOD, Form::None, modulo},  {Operation::NEGD, Form::None, negate},
          {Operation::INVD, Form::None, invert}};
}

}  // namespace merker::interpreter
