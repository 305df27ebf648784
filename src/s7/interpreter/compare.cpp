// ==I <>I … ==D … ==R (S7-INSTR-72 … -74): AKKU2 compared with AKKU1.
#include "check/relation.h"
#include "interpreter/handlers.h"
#include "interpreter/real_number.h"

namespace merker::interpreter {
namespace {

using block::Relation;
using mc7::Operation;

void finish(cpu::StatusWord& s, bool result) {
  s.rlo = s.sta = result;
  s.orBit = false;
  s.er = true;
}

template <Relation R, typename Number>
const Op* integers(cpu::Machine& m, const Op* op) {
  const auto a = static_cast<Number>(m.registers.accu[1]),
             b = static_cast<Number>(m.registers.accu[0]);
  cpu::StatusWord& s = m.registers.status;
  s.cc0 = a < b;
  s.cc1 = a > b;
  s.ov = false;
  finish(s, block::relates(a, R, b));
  return op + 1;
}

// No number on either side: 11, OV, and no relation holds (S7-OPEN-47).
template <Relation R>
const Op* reals(cpu::Machine& m, const Op* op) {
  const float a = real(m, 1), b = real(m, 0);
  cpu::StatusWord& s = m.registers.status;
  if (std::isnan(a) || std::isnan(b)) {
    setInvalid(s);
    finish(s, false);
    return op + 1;
  }
  s.cc0 = a < b;
  s.cc1 = a > b;
  s.ov = false;
  finish(s, block::relates(a, R, b));
  return op + 1;
}

template <Relation R>
void add(Rows& rows, Operation i, Operation d, Operation r) {
  rows.insert(rows.end(), {{i, Form::None, integers<R, std::int16_t>},
                           {d, Form::None, integers<R, std::int32_t>},
                           {r, Form::None, reals<R>}});
}

}  // namespace

Rows compareRows() {
  Rows rows;
  add<Relation::Equal>(rows, Operation::EQ_I, Operation::EQ_D, Operation::EQ_R);
  add<Relation::NotEqual>(rows, Operation::NE_I, Operation::NE_D, Operation::NE_R);
  add<Relation::Less>(rows, Operation::LT_I, Operation::LT_D, Operation::LT_R);
  add<Relation::LessEqual>(rows, Operation::LE_I, Operation::LE_D, Operation::LE_R);
  add<Relation::Greater>(rows, Operation::GT_I, Operation::GT_D, Operation::GT_R);
  add<Relation::GreaterEqual>(rows, Operation::GE_I, Operation::GE_D, Operation::GE_R);
  return rows;
}

}  // namespace merker::interpreter
