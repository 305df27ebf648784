// ZV ZR S R FR U … L LC with a counter (S7-INSTR-11, -33 … -37, -38, -39).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/logic.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using cpu::S5Counter;
using cpu::SyncError;

// The counter, or null with the error (16#27: number beyond the model's counters).
S5Counter* counterOf(cpu::Machine& m, const Op* op, SyncError& error) {
  std::uint32_t number = 0;
  error = numberOperand(m, op, number);
  if (error) return nullptr;
  if (number < m.counters.size()) return &m.counters[number];
  error = {.code = cpu::ErrorCode::CounterNumber, .detail = number};
  return nullptr;
}

template <void (S5Counter::*Step)(bool)>
const Op* step(cpu::Machine& m, const Op* op) {
  SyncError error;
  if (S5Counter* counter = counterOf(m, op, error)) (counter->*Step)(m.registers.status.rlo);
  m.registers.status.endChain();
  return goOn(m, op, error);
}

const Op* set(cpu::Machine& m, const Op* op) {
  SyncError error;
  S5Counter* counter = counterOf(m, op, error);
  if (counter != nullptr && !counter->set(m.registers.status.rlo, m.registers.low(0)))
    error = {.code = cpu::ErrorCode::Bcd};  // S7-CNT-03
  m.registers.status.endChain();
  return goOn(m, op, error);
}

template <typename Logic>
const Op* query(cpu::Machine& m, const Op* op) {
  SyncError error;
  const S5Counter* counter = counterOf(m, op, error);
  Logic::apply(m.registers.status, counter != nullptr && counter->count > 0);
  return goOn(m, op, error);
}

template <bool Bcd>
const Op* load(cpu::Machine& m, const Op* op) {
  SyncError error;
  const S5Counter* counter = counterOf(m, op, error);
  m.registers.load(counter == nullptr ? 0u : Bcd ? counter->bcd() : counter->count);
  return goOn(m, op, error);
}

}  // namespace

Rows counterRows() {
  using mc7::Operation;
  return {{Operation::COUNT_UP, Form::Counter, step<&S5Counter::up>},
          {Operation::COUNT_DOWN, Form::Counter, step<&S5Counter::down>},
          {Operation::ENABLE, Form::Counter, step<&S5Counter::enable>},
          {Operation::RESET_BIT, Form::Counter, step<&S5Counter::reset>},
          {Operation::SET_BIT, Form::Counter, set},
          {Operation::AND, Form::Counter, query<And>},
          {Operation::AND_NOT, Form::Counter, query<AndNot>},
          {Operation::OR, Form::Counter, query<Or>},
          {Operation::OR_NOT, Form::Counter, query<OrNot>},
          {Operation::XOR, Form::Counter, query<Xor>},
          {Operation::XOR_NOT, Form::Counter, query<XorNot>},
          {Operation::LOAD, Form::Counter, load<false>},
          {Operation::LOAD_BCD, Form::Counter, load<true>}};
}

}  // namespace merker::interpreter
