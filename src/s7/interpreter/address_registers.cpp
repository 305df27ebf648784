// LAR TAR +AR (S7-INSTR-41 … -44).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

template <int N>
std::uint32_t& ar(cpu::Machine& m) {
  return N == 2 ? m.registers.ar2 : m.registers.ar1;
}

template <int N>
const Op* fromAccu(cpu::Machine& m, const Op* op) {
  ar<N>(m) = m.registers.accu[0];
  return op + 1;
}
template <int N>
const Op* fromConstant(cpu::Machine& m, const Op* op) {
  ar<N>(m) = op->value;
  return op + 1;
}
template <int N>
const Op* fromMemory(cpu::Machine& m, const Op* op) {
  std::uint32_t value = 0;
  const cpu::SyncError error = readOperand(m, op, Width::DWord, value);
  ar<N>(m) = value;
  return goOn(m, op, error);
}
const Op* ar1FromAr2(cpu::Machine& m, const Op* op) {
  m.registers.ar1 = m.registers.ar2;
  return op + 1;
}

template <int N>
const Op* toAccu(cpu::Machine& m, const Op* op) {
  m.registers.load(ar<N>(m));
  return op + 1;
}
template <int N>
const Op* toMemory(cpu::Machine& m, const Op* op) {
  return goOn(m, op, writeOperand(m, op, Width::DWord, ar<N>(m)));
}
const Op* ar1ToAr2(cpu::Machine& m, const Op* op) {
  m.registers.ar2 = m.registers.ar1;
  return op + 1;
}

const Op* exchange(cpu::Machine& m, const Op* op) {
  std::swap(m.registers.ar1, m.registers.ar2);
  return op + 1;
}

// S7-INSTR-44: bits 23..0 only, the area stays.
void advance(std::uint32_t& reg, std::uint32_t distance) {
  reg = (reg & 0xFF000000u) | ((reg + distance) & 0x00FFFFFFu);
}
template <int N>
const Op* addAccu(cpu::Machine& m, const Op* op) {
  advance(ar<N>(m), static_cast<std::uint32_t>(static_cast<std::int16_t>(m.registers.low(0))));
  return op + 1;
}
template <int N>
const Op* addConstant(cpu::Machine& m, const Op* op) {
  advance(ar<N>(m), static_cast<std::uint32_t>(static_cast<std::int16_t>(op->value)));
  return op + 1;
}

template <int N>
void add(Rows& rows, Operation load, Operation transfer, Operation plus) {
  rows.insert(rows.end(), {{load, Form::None, fromAccu<N>},
                           {load, Form::Constant, fromConstant<N>},
                           {transfer, Form::None, toAccu<N>},
                           {plus, Form::None, addAccu<N>},
                           {plus, Form::Constant, addConstant<N>}});
}

// Operands in memory: MD, DBD, DID, LD. A place in the image is found by its area again.
template <int N>
void addMemory(Rows& rows, Operation load, Operation transfer) {
  for (const Form form : {Form::Data, Form::Instance, Form::Local, Form::Memory}) {
    rows.push_back({load, form, fromMemory<N>});
    rows.push_back({transfer, form, toMemory<N>});
  }
}

}  // namespace

Rows addressRegisterRows() {
  Rows rows{{Operation::LAR1, Form::Other, ar1FromAr2},
            {Operation::TAR1, Form::Other, ar1ToAr2},
            {Operation::TAR, Form::None, exchange}};
  add<1>(rows, Operation::LAR1, Operation::TAR1, Operation::ADD_AR1);
  add<2>(rows, Operation::LAR2, Operation::TAR2, Operation::ADD_AR2);
  addMemory<1>(rows, Operation::LAR1, Operation::TAR1);
  addMemory<2>(rows, Operation::LAR2, Operation::TAR2);
  return rows;
}

}  // namespace merker::interpreter
