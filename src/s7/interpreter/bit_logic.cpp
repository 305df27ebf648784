// U UN O ON X XN with a bit in memory (S7-INSTR-02 … -07).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/logic.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

template <typename Logic>
const Op* anywhere(cpu::Machine& m, const Op* op) {
  std::uint32_t bit = 0;
  const cpu::SyncError error = readOperand(m, op, Width::Bit, bit);
  Logic::apply(m.registers.status, bit != 0);
  return goOn(m, op, error);
}

template <typename Logic, Form F>
const Op* direct(cpu::Machine& m, const Op* op) {
  const std::uint8_t* byte = readable<F>(m, op, 1);
  if (byte == nullptr) [[unlikely]]
    return anywhere<Logic>(m, op);
  Logic::apply(m.registers.status, (*byte & op->mask) != 0);
  return op + 1;
}

template <typename Logic>
void add(Rows& rows, mc7::Operation operation) {
  rows.insert(rows.end(), {{operation, Form::Image, direct<Logic, Form::Image>},
                           {operation, Form::Data, direct<Logic, Form::Data>},
                           {operation, Form::Instance, direct<Logic, Form::Instance>},
                           {operation, Form::Local, direct<Logic, Form::Local>},
                           {operation, Form::Memory, anywhere<Logic>}});
}

}  // namespace

Rows bitLogicRows() {
  using mc7::Operation;
  Rows rows;
  add<And>(rows, Operation::AND);
  add<AndNot>(rows, Operation::AND_NOT);
  add<Or>(rows, Operation::OR);
  add<OrNot>(rows, Operation::OR_NOT);
  add<Xor>(rows, Operation::XOR);
  add<XorNot>(rows, Operation::XOR_NOT);
  return rows;
}

}  // namespace merker::interpreter
