// U( UN( O( ON( X( XN( ) and O without operand (S7-INSTR-08 … -10).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

// S7-INSTR-08: depth by model (S7-CPU-27).
const Op* open(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  const std::size_t used =
      m.brackets.size() - (m.levels.empty() ? 0u : m.levels.back().bracketBase);
  if (used >= m.model->bracketDepth) return stop(m, op, cpu::Event::StopBracketStack);
  m.brackets.push_back({.function = static_cast<std::uint8_t>(op->operation),
                        .rlo = s.rlo,
                        .orBit = s.orBit,
                        .er = s.er});
  s.sta = true;
  s.endChain();
  return op + 1;
}

// What stood before the bracket, combined with what came out of it. A stored /ER of 0 makes it a
// first check.
bool combine(const cpu::Bracket& before, bool inner) {
  switch (static_cast<Operation>(before.function)) {
    case Operation::AND_OPEN:
      return (before.rlo || !before.er) && inner;
    case Operation::AND_NOT_OPEN:
      return (before.rlo || !before.er) && !inner;
    case Operation::OR_OPEN:
      return (before.rlo && before.er) || inner;
    case Operation::OR_NOT_OPEN:
      return (before.rlo && before.er) || !inner;
    case Operation::XOR_OPEN:
      return (before.rlo && before.er) != inner;
    default:
      return (before.rlo && before.er) != !inner;
  }
}

// S7-INSTR-09
const Op* close(cpu::Machine& m, const Op* op) {
  if (m.brackets.size() <= m.top->bracketDepth) return stop(m, op, cpu::Event::StopBracketStack);
  const cpu::Bracket before = m.brackets.back();
  m.brackets.pop_back();
  const auto function = static_cast<Operation>(before.function);
  const bool isAnd = function == Operation::AND_OPEN || function == Operation::AND_NOT_OPEN;
  cpu::StatusWord& s = m.registers.status;
  s.orBit = isAnd && before.orBit && before.er;
  s.rlo = combine(before, s.rlo) || s.orBit;
  s.sta = s.er = true;
  return op + 1;
}

// S7-INSTR-10: AND before OR.
const Op* andBeforeOr(cpu::Machine& m, const Op* op) {
  cpu::StatusWord& s = m.registers.status;
  s.orBit = (s.rlo || s.orBit) && s.er;
  s.er = s.rlo && s.er;
  s.sta = true;
  return op + 1;
}

}  // namespace

Rows bracketRows() {
  Rows rows{{Operation::CLOSE, Form::None, close},
            {Operation::AND_BEFORE_OR, Form::None, andBeforeOr}};
  for (const Operation operation :
       {Operation::AND_OPEN, Operation::AND_NOT_OPEN, Operation::OR_OPEN, Operation::OR_NOT_OPEN,
        Operation::XOR_OPEN, Operation::XOR_NOT_OPEN})
    rows.push_back({operation, Form::None, open});
  return rows;
}

}  // namespace merker::interpreter
