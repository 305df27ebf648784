// T: to memory and to the status word (S7-INSTR-40, -46). With the master control relay off T
// writes 0.
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using mc7::Operation;

std::uint32_t source(const cpu::Machine& m) { return m.mcrOff ? 0 : m.registers.accu[0]; }

template <Width W>
const Op* anywhere(cpu::Machine& m, const Op* op) {
  return goOn(m, op, writeOperand(m, op, W, source(m)));
}

template <Width W, Form F>
const Op* direct(cpu::Machine& m, const Op* op) {
  std::uint8_t* bytes = writable<F>(m, op, byteCount(W));
  if (bytes == nullptr || (F != Form::Image && (op->value & 7) != 0)) [[unlikely]]
    return anywhere<W>(m, op);
  cpu::storeBytes(bytes, W, source(m));
  return op + 1;
}

template <Width W>
void add(Rows& rows) {
  rows.insert(rows.end(), {{Operation::TRANSFER, Form::Image, direct<W, Form::Image>, W},
                           {Operation::TRANSFER, Form::Data, direct<W, Form::Data>, W},
                           {Operation::TRANSFER, Form::Instance, direct<W, Form::Instance>, W},
                           {Operation::TRANSFER, Form::Local, direct<W, Form::Local>, W},
                           {Operation::TRANSFER, Form::Memory, anywhere<W>, W}});
}

const Op* statusWord(cpu::Machine& m, const Op* op) {
  m.registers.status = cpu::StatusWord::fromWord(m.registers.accu[0]);
  return op + 1;
}

}  // namespace

Rows transferRows() {
  Rows rows{{Operation::TRANSFER_STW, Form::None, statusWord},
            {Operation::TRANSFER_STW, Form::Other, statusWord}};
  add<Width::Byte>(rows);
  add<Width::Word>(rows);
  add<Width::DWord>(rows);
  return rows;
}

}  // namespace merker::interpreter
