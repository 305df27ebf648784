// L: constants, memory, status word, data block registers, P## (S7-INSTR-38, -45, -49, -50).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

const Op* constant(cpu::Machine& m, const Op* op) {
  m.registers.load(op->value);
  return op + 1;
}

template <Width W>
const Op* anywhere(cpu::Machine& m, const Op* op) {
  std::uint32_t value = 0;
  const cpu::SyncError error = readOperand(m, op, W, value);
  m.registers.load(value);
  return goOn(m, op, error);
}

template <Width W, Form F>
const Op* direct(cpu::Machine& m, const Op* op) {
  const std::uint8_t* bytes = readable<F>(m, op, byteCount(W));
  if (bytes == nullptr || (F != Form::Image && (op->value & 7) != 0)) [[unlikely]]
    return anywhere<W>(m, op);
  m.registers.load(cpu::loadBytes(bytes, W));
  return op + 1;
}

template <Width W>
void add(Rows& rows) {
  rows.insert(rows.end(), {{Operation::LOAD, Form::Image, direct<W, Form::Image>, W},
                           {Operation::LOAD, Form::Data, direct<W, Form::Data>, W},
                           {Operation::LOAD, Form::Instance, direct<W, Form::Instance>, W},
                           {Operation::LOAD, Form::Local, direct<W, Form::Local>, W},
                           {Operation::LOAD, Form::Memory, anywhere<W>, W}});
}

// S7-INSTR-45: an S7-300 shows /ER, STA and OR as 0; CPUs with four accumulators show all.
const Op* statusWord(cpu::Machine& m, const Op* op) {
  constexpr std::uint32_t kHidden = 0b0'0000'1101;
  const std::uint32_t word = m.registers.status.word();
  m.registers.load(m.fourAccumulators ? word : word & ~kHidden);
  return op + 1;
}

// S7-INSTR-49, -50
const Op* dataBlockInfo(cpu::Machine& m, const Op* op) {
  const cpu::Registers& r = m.registers;
  switch (static_cast<mc7::DataBlockQuery>(op->value)) {
    case mc7::DataBlockQuery::DbLength:
      m.registers.load(r.db.length);
      break;
    case mc7::DataBlockQuery::DiLength:
      m.registers.load(r.di.length);
      break;
    case mc7::DataBlockQuery::DbNumber:
      m.registers.load(r.db.number);
      break;
    case mc7::DataBlockQuery::DiNumber:
      m.registers.load(r.di.number);
      break;
  }
  return op + 1;
}

// L P##parameter: the pointer in the list behind the call (S7-IND-09).
const Op* parameterAddress(cpu::Machine& m, const Op* op) {
  const bool exists = op->value < m.top->parameterCount;
  m.registers.load(exists ? m.top->parameters[op->value] : 0);
  if (exists) return op + 1;
  return fail(m, op,
              {.code = cpu::ErrorCode::AreaRead, .width = Width::DWord, .detail = op->value});
}

// Both kinds of "other" operands of L share one form.
const Op* other(cpu::Machine& m, const Op* op) {
  return op->kind == mc7::OperandKind::DataBlockInfo ? dataBlockInfo(m, op)
                                                     : parameterAddress(m, op);
}

}  // namespace

Rows loadRows() {
  Rows rows{{Operation::LOAD, Form::Constant, constant},
            {Operation::LOAD, Form::Other, other},
            {Operation::LOAD_STW, Form::None, statusWord},
            {Operation::LOAD_STW, Form::Other, statusWord}};
  add<Width::Byte>(rows);
  add<Width::Word>(rows);
  add<Width::DWord>(rows);
  return rows;
}

}  // namespace merker::interpreter
