// +R -R *R /R NEGR ABS (S7-INSTR-60 … -64).
#include "interpreter/handlers.h"
#include "interpreter/real_number.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

struct Plus {
  static float of(float a, float b) { return a + b; }
};
struct Minus {
  static float of(float a, float b) { return a - b; }
};
struct Times {
  static float of(float a, float b) { return a * b; }
};
// x/0 is infinite, 0/0 no number: IEEE 754, which C++ leaves open.
struct Divide {
  static float of(float a, float b) {
    if (b != 0.0f) return a / b;
    if (a == 0.0f || std::isnan(a) || std::isnan(b)) return std::nanf("");
    return std::signbit(a) == std::signbit(b) ? HUGE_VALF : -HUGE_VALF;
  }
};

template <typename Function>
const Op* binary(cpu::Machine& m, const Op* op) {
  setReal(m, Function::of(real(m, 1), real(m, 0)));
  dropOperand(m);
  return op + 1;
}

const Op* negate(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] ^= 0x8000'0000u;
  return op + 1;
}

const Op* absolute(cpu::Machine& m, const Op* op) {
  m.registers.accu[0] &= 0x7FFF'FFFFu;
  return op + 1;
}

}  // namespace

Rows realRows() {
  return {
      {Operation::ADD_R, Form::None, binary<Plus>},  {Operation::SUB_R, Form::None, binary<Minus>},
      {Operation::MUL_R, Form::None, binary<Times>}, {Operation::DIV_R, Form::None, binary<Divide>},
      {Operation::NEGR, Form::None, negate},         {Operation::ABS, Form::None, absolute}};
}

}  // namespace merker::interpreter
