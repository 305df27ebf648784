// RND RND- RND+ TRUNC: REAL to DINT (S7-INSTR-98 … -101).
#include "interpreter/handlers.h"
#include "interpreter/real_number.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

// Half to even, whatever rounding mode the host has.
double nearest(double x) {
  const double below = std::floor(x), rest = x - below;
  if (rest != 0.5) return rest < 0.5 ? below : below + 1;
  return std::fmod(below, 2) == 0 ? below : below + 1;
}
double below(double x) { return std::floor(x); }
double above(double x) { return std::ceil(x); }
double cut(double x) { return std::trunc(x); }

// No number, or beyond DINT: AKKU1 unchanged, OV and OS.
template <double (*Function)(double)>
const Op* toDint(cpu::Machine& m, const Op* op) {
  const double result = Function(real(m, 0));
  const bool valid = result >= INT32_MIN && result <= INT32_MAX;
  setOverflow(m.registers.status, !valid);
  if (valid) m.registers.accu[0] = static_cast<std::uint32_t>(static_cast<std::int32_t>(result));
  return op + 1;
}

}  // namespace

Rows roundRows() {
  return {{Operation::RND, Form::None, toDint<nearest>},
          {Operation::RND_MINUS, Form::None, toDint<below>},
          {Operation::RND_PLUS, Form::None, toDint<above>},
          {Operation::TRUNC, Form::None, toDint<cut>}};
}

}  // namespace merker::interpreter
