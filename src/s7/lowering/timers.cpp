// Timers and counters (S7-INSTR-11, -26 … -37, -39; S7-TMR, S7-CNT). What begins or ends a time is
// left to the interpreter; a start that changes nothing is most of what a program executes.
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Field;
using icode::Item;
using icode::Opcode;
using icode::Value;
using Kind = icode::TimerKind;
using mc7::OperandKind;
using mc7::Operation;

void endChain(Lowering& l) {
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}

bool isTimer(const Lowering& l) {
  return l.operand().kind == OperandKind::Timer && l.operand().value < l.model.timers;
}
bool isCounter(const Lowering& l) {
  return l.operand().kind == OperandKind::Counter && l.operand().value < l.model.counters;
}

Value read(Lowering& l, Field field) { return l.to.field(field, l.operand().value); }
void write(Lowering& l, Field field, Value value) {
  l.to.setField(field, l.operand().value, value);
}

// Gives what the edge memory says, and keeps the RLO in it.
Value rising(Lowering& l, Field memory) {
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  const Value edge = b.andBit(rlo, b.notBit(read(l, memory)));
  write(l, memory, rlo);
  return edge;
}

// The word, or 0 if told.
Value zeroIf(Lowering& l, Value bit, Value word) {
  icode::Builder& b = l.to;
  return b.make(Opcode::And, word, b.make(Opcode::Sub, b.make(Opcode::ToWord, bit), b.constant(1)));
}

// S7-TMR-10 … -19: without an edge nothing happens, but a 0 ends a pulse and an on-delay, and with
// an off-delay that is held a 0 starts the time.
template <Kind K>
bool start(Lowering& l) {
  if (!isTimer(l)) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  b.guard(b.notBit(b.xorBit(rlo, read(l, Field::TimerStartEdge))));
  if constexpr (K == Kind::Pulse || K == Kind::OnDelay)
    b.guard(b.orBit(rlo, b.notBit(read(l, Field::TimerStarted))));
  if constexpr (K == Kind::OffDelay) {
    b.guard(b.orBit(rlo, b.notBit(read(l, Field::TimerHeld))));
    const Value same =
        b.make(Opcode::Equal, read(l, Field::TimerKind), b.constant(static_cast<std::uint32_t>(K)));
    b.guard(b.orBit(b.notBit(rlo), same));
  }
  endChain(l);
  return true;
}

// S7-TMR-21, S7-CNT-13: the next start instruction with RLO 1 counts as an edge again.
bool enable(Lowering& l) {
  if (!isTimer(l) && !isCounter(l)) return false;
  icode::Builder& b = l.to;
  const bool timer = isTimer(l);
  const Value keep = b.notBit(rising(l, timer ? Field::TimerEnableEdge : Field::CounterEnableEdge));
  const auto clear = [&](Field field) { write(l, field, b.andBit(read(l, field), keep)); };
  if (timer) {
    clear(Field::TimerStartEdge);
  } else {
    clear(Field::CounterSetEdge);
    clear(Field::CounterUpEdge);
    clear(Field::CounterDownEdge);
  }
  endChain(l);
  return true;
}

// S7-CNT-08, -09: stays at 999 and at 0.
template <bool Up>
bool step(Lowering& l) {
  if (!isCounter(l)) return false;
  icode::Builder& b = l.to;
  const Value edge = rising(l, Up ? Field::CounterUpEdge : Field::CounterDownEdge);
  const Value count = read(l, Field::CounterCount);
  const Value room = Up ? b.make(Opcode::Below, count, b.constant(999))
                        : b.make(Opcode::NotEqual, count, b.constant(0));
  const Value by = b.make(Opcode::ToWord, b.andBit(edge, room));
  write(l, Field::CounterCount, b.make(Up ? Opcode::Add : Opcode::Sub, count, by));
  endChain(l);
  return true;
}

Value timerValue(Lowering& l, bool bcd) {
  icode::Builder& b = l.to;
  const Value units = b.timerUnits(l.operand().value);
  if (!bcd) return units;
  const Value base = b.withNumber(Opcode::Shl, read(l, Field::TimerBase), 12);
  return b.make(Opcode::Or, base, toBcd(l, units, 3));
}

template <bool Bcd>
bool load(Lowering& l) {
  if (!isTimer(l) && !isCounter(l)) return false;
  icode::Builder& b = l.to;
  Value value = icode::kNoValue;
  if (isTimer(l))
    value = timerValue(l, Bcd);
  else
    value = Bcd ? toBcd(l, read(l, Field::CounterCount), 3) : read(l, Field::CounterCount);
  b.set(Item::Accu2, b.get(Item::Accu1));
  b.set(Item::Accu1, value);
  return true;
}

constexpr Row kTimersRows[] = {{Operation::TIMER_SI, start<Kind::Pulse>},
                               {Operation::TIMER_SV, start<Kind::ExtendedPulse>},
                               {Operation::TIMER_SE, start<Kind::OnDelay>},
                               {Operation::TIMER_SS, start<Kind::StoredOnDelay>},
                               {Operation::TIMER_SA, start<Kind::OffDelay>},
                               {Operation::ENABLE, enable},
                               {Operation::COUNT_UP, step<true>},
                               {Operation::COUNT_DOWN, step<false>},
                               {Operation::LOAD_BCD, load<true>}};

}  // namespace

std::span<const Row> timerRows() { return kTimersRows; }

// S7-TMR: started and not yet over, the delays started and over; SS and SA also while held. Only
// the first of these changes between one turn of a loop and the next.
Value timerStatus(Lowering& l) {
  icode::Builder& b = l.to;
  const auto number = [&b](Kind kind) { return b.constant(static_cast<std::uint32_t>(kind)); };
  static_assert(Kind::StoredOnDelay > Kind::OnDelay && Kind::OffDelay > Kind::StoredOnDelay);
  const Value kind = read(l, Field::TimerKind);
  const Value isDelay =
      b.make(Opcode::Below, b.make(Opcode::Sub, kind, number(Kind::OnDelay)), b.constant(2));
  const Value isStored = b.notBit(b.make(Opcode::Below, kind, number(Kind::StoredOnDelay)));
  const Value over = b.xorBit(b.timerRuns(l.operand().value), isDelay);
  return b.orBit(b.andBit(over, read(l, Field::TimerStarted)),
                 b.andBit(isStored, read(l, Field::TimerHeld)));
}

bool loadTimerOrCounter(Lowering& l) { return load<false>(l); }

// S7-TMR-06, S7-CNT-04: as long as RLO is 1.
bool resetTimerOrCounter(Lowering& l) {
  if (!isTimer(l) && !isCounter(l)) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  const auto clear = [&](Field field) { write(l, field, zeroIf(l, rlo, read(l, field))); };
  if (isTimer(l)) {
    for (const Field field :
         {Field::TimerStarted, Field::TimerHeld, Field::TimerFrozen, Field::TimerBase})
      clear(field);
  } else {
    clear(Field::CounterCount);
  }
  endChain(l);
  return true;
}

// S7-CNT-02, -03: the count from BCD, at an edge.
bool setCounter(Lowering& l) {
  if (!isCounter(l)) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  const Value quiet = b.orBit(b.notBit(rlo), read(l, Field::CounterSetEdge));
  const Value bcd = b.make(Opcode::And, b.get(Item::Accu1), b.constant(0xFFF));
  b.guard(b.orBit(quiet, isBcd(l, bcd)));
  const Value edge = rising(l, Field::CounterSetEdge);
  const Value kept = zeroIf(l, edge, read(l, Field::CounterCount));
  const Value set = zeroIf(l, b.notBit(edge), fromBcd(l, bcd, 3));
  write(l, Field::CounterCount, b.make(Opcode::Or, kept, set));
  endChain(l);
  return true;
}

}  // namespace merker::translate
