// SI SV SE SS SA FR R U … L LC with a timer (S7-INSTR-11, -26 … -32, -38, -39).
#include "interpreter/fault.h"
#include "interpreter/handlers.h"
#include "interpreter/logic.h"
#include "interpreter/operand_access.h"

namespace merker::interpreter {
namespace {

using cpu::S5Timer;
using cpu::SyncError;

// The timer, or null with the error (16#26: number beyond the model's timers).
S5Timer* timerOf(cpu::Machine& m, const Op* op, SyncError& error) {
  std::uint32_t number = 0;
  error = numberOperand(m, op, number);
  if (error) return nullptr;
  if (number < m.timers.size()) return &m.timers[number];
  error = {.code = cpu::ErrorCode::TimerNumber, .detail = number};
  return nullptr;
}

template <S5Timer::Kind K>
const Op* start(cpu::Machine& m, const Op* op) {
  SyncError error;
  S5Timer* timer = timerOf(m, op, error);
  const auto value = m.registers.low(0);
  if (timer != nullptr && !timer->start(K, m.registers.status.rlo, value, m.clock))
    error = {.code = cpu::ErrorCode::Bcd};  // S7-TMR-04
  m.registers.status.endChain();
  return goOn(m, op, error);
}

const Op* enable(cpu::Machine& m, const Op* op) {
  SyncError error;
  if (S5Timer* timer = timerOf(m, op, error)) timer->enable(m.registers.status.rlo);
  m.registers.status.endChain();
  return goOn(m, op, error);
}

const Op* reset(cpu::Machine& m, const Op* op) {
  SyncError error;
  if (S5Timer* timer = timerOf(m, op, error)) timer->reset(m.registers.status.rlo);
  m.registers.status.endChain();
  return goOn(m, op, error);
}

template <typename Logic>
const Op* query(cpu::Machine& m, const Op* op) {
  SyncError error;
  const S5Timer* timer = timerOf(m, op, error);
  Logic::apply(m.registers.status, timer != nullptr && timer->status(m.clock));
  return goOn(m, op, error);
}

template <bool Bcd>
const Op* load(cpu::Machine& m, const Op* op) {
  SyncError error;
  const S5Timer* timer = timerOf(m, op, error);
  if (timer != nullptr) m.loadedTimers[static_cast<std::size_t>(timer - m.timers.data())] = 1;
  m.registers.load(timer == nullptr ? 0u : Bcd ? timer->s5time(m.clock) : timer->units(m.clock));
  return goOn(m, op, error);
}

}  // namespace

Rows timerRows() {
  using mc7::Operation;
  return {{Operation::TIMER_SI, Form::Timer, start<S5Timer::Kind::Pulse>},
          {Operation::TIMER_SV, Form::Timer, start<S5Timer::Kind::ExtendedPulse>},
          {Operation::TIMER_SE, Form::Timer, start<S5Timer::Kind::OnDelay>},
          {Operation::TIMER_SS, Form::Timer, start<S5Timer::Kind::StoredOnDelay>},
          {Operation::TIMER_SA, Form::Timer, start<S5Timer::Kind::OffDelay>},
          {Operation::ENABLE, Form::Timer, enable},
          {Operation::RESET_BIT, Form::Timer, reset},
          {Operation::AND, Form::Timer, query<And>},
          {Operation::AND_NOT, Form::Timer, query<AndNot>},
          {Operation::OR, Form::Timer, query<Or>},
          {Operation::OR_NOT, Form::Timer, query<OrNot>},
          {Operation::XOR, Form::Timer, query<Xor>},
          {Operation::XOR_NOT, Form::Timer, query<XorNot>},
          {Operation::LOAD, Form::Timer, load<false>},
          {Operation::LOAD_BCD, Form::Timer, load<true>}};
}

}  // namespace merker::interpreter
