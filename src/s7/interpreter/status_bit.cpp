// Queries of status bits (S7-STW-14), and the instructions that set the RLO itself.
#include "interpreter/handlers.h"
#include "interpreter/logic.h"

namespace merker::interpreter {
namespace {

bool stateOf(const cpu::StatusWord& s, mc7::StatusQuery query) {
  using mc7::StatusQuery;
  switch (query) {
    case StatusQuery::OS:
      return s.os;
    case StatusQuery::OV:
      return s.ov;
    case StatusQuery::Greater:
      return s.cc1 && !s.cc0;
    case StatusQuery::Less:
      return !s.cc1 && s.cc0;
    case StatusQuery::Unordered:
      return s.cc1 && s.cc0;
    case StatusQuery::NotEqual:
      return s.cc1 != s.cc0;
    case StatusQuery::Equal:
      return !s.cc1 && !s.cc0;
    case StatusQuery::GreaterEqual:
      return !s.cc0;
    case StatusQuery::LessEqual:
      return !s.cc1;
    case StatusQuery::BIE:
      return s.br;
  }
  return false;
}

template <typename Logic>
const Op* query(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  Logic::apply(s, stateOf(s, static_cast<mc7::StatusQuery>(op->value)));
  return op + 1;
}

// S7-INSTR-23
const Op* clr(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  s.rlo = s.sta = false;
  s.endChain();
  return op + 1;
}
const Op* set(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  s.rlo = s.sta = true;
  s.endChain();
  return op + 1;
}

// S7-INSTR-24
const Op* invert(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  s.rlo = !s.rlo;
  s.sta = true;
  return op + 1;
}

// S7-INSTR-25
const Op* save(cpu::Machine& m, const Op* op) {
  m.registers.status.br = m.registers.status.rlo;
  return op + 1;
}

}  // namespace

Rows statusBitRows() {
  using mc7::Operation;
  return {{Operation::AND, Form::StatusBit, query<And>},
          {Operation::AND_NOT, Form::StatusBit, query<AndNot>},
          {Operation::OR, Form::StatusBit, query<Or>},
          {Operation::OR_NOT, Form::StatusBit, query<OrNot>},
          {Operation::XOR, Form::StatusBit, query<Xor>},
          {Operation::XOR_NOT, Form::StatusBit, query<XorNot>},
          {Operation::CLR, Form::None, clr},
          {Operation::SET, Form::None, set},
          {Operation::NOT, Form::None, invert},
          {Operation::SAVE, Form::None, save}};
}

}  // namespace merker::interpreter
