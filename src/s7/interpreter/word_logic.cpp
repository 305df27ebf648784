// UW OW XOW UD OD XOD (S7-INSTR-12 … -17): with AKKU2 or with a constant.
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

struct And {
  static std::uint32_t of(std::uint32_t a, std::uint32_t b) { return a & b; }
};
struct Or {
  static std::uint32_t of(std::uint32_t a, std::uint32_t b) { return a | b; }
};
struct Xor {
  static std::uint32_t of(std::uint32_t a, std::uint32_t b) { return a ^ b; }
};

// A1 = (result not 0), A0 and OV 0 (S7-STW-13).
void setStatus(cpu::StatusWord& s, std::uint32_t result) {
  s.cc1 = result != 0;
  s.cc0 = s.ov = false;
}

template <typename Function, bool FromConstant>
const Op* word(cpu::Machine& m, const Op* op) {
  const std::uint32_t other = FromConstant ? op->value : m.registers.accu[1];
  const std::uint32_t result = Function::of(m.registers.accu[0], other) & 0xFFFF;
  m.registers.setLow(result);
  setStatus(m.registers.status, result);
  return op + 1;
}

template <typename Function, bool FromConstant>
const Op* doubleWord(cpu::Machine& m, const Op* op) {
  const std::uint32_t other = FromConstant ? op->value : m.registers.accu[1];
  m.registers.accu[0] = Function::of(m.registers.accu[0], other);
  setStatus(m.registers.status, m.registers.accu[0]);
  return op + 1;
}

template <typename Function>
void add(Rows& rows, Operation w, Operation d) {
  rows.insert(rows.end(), {{w, Form::None, word<Function, false>},
                           {w, Form::Constant, word<Function, true>},
                           {d, Form::None, doubleWord<Function, false>},
                           {d, Form::Constant, doubleWord<Function, true>}});
}

}  // namespace

Rows wordLogicRows() {
  Rows rows;
  add<And>(rows, Operation::AND_W, Operation::AND_D);
  add<Or>(rows, Operation::OR_W, Operation::OR_D);
  add<Xor>(rows, Operation::XOR_W, Operation::XOR_D);
  return rows;
}

}  // namespace merker::interpreter
