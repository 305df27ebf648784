// Timers and counters (S7-INSTR-11, -26 … -37, -39; S7-TMR, S7-CNT). What begins or ends a time is
// left to the interpreter; a start that changes nothing is most of what a program executes.
#include <algorithm>

#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Cell;
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

bool isAnyOf(OperandKind kind, const std::array<OperandKind, 3>& kinds) {
  return std::ranges::find(kinds, kind) != kinds.end();
}

constexpr std::array kTimers{OperandKind::Timer, OperandKind::TimerIndirect,
                             OperandKind::TimerParameter};
constexpr std::array kCounters{OperandKind::Counter, OperandKind::CounterIndirect,
                               OperandKind::CounterParameter};

std::optional<Cell> numbered(std::uint32_t number, unsigned count) {
  return number < count ? std::optional(Cell{.number = number}) : std::nullopt;
}

// Of the CPU's `count`; what is known only when the region runs is guarded.
std::optional<Cell> cellOf(Lowering& l, OperandKind direct, unsigned count) {
  if (l.operand().kind == direct) return numbered(l.operand().value, count);
  const auto value = numberOperand(l);
  if (!value) return std::nullopt;
  if (const auto number = l.to.number(*value)) return numbered(*number, count);
  l.to.guard(l.to.make(Opcode::Below, *value, l.to.constant(count)));
  return Cell{.value = *value};
}

// Gives what the edge memory says, and keeps the RLO in it.
Value rising(icode::Builder& b, Field memory, const Cell& cell) {
  const Value rlo = b.get(Item::Rlo);
  const Value edge = b.andBit(rlo, b.notBit(b.field(memory, cell)));
  b.setField(memory, cell, rlo);
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
  const auto timer = timerOf(l);
  if (!timer) return false;
  icode::Builder& b = l.to;
  const auto read = [&](Field field) { return b.field(field, *timer); };
  const Value rlo = b.get(Item::Rlo);
  b.guard(b.notBit(b.xorBit(rlo, read(Field::TimerStartEdge))));
  if constexpr (K == Kind::Pulse || K == Kind::OnDelay)
    b.guard(b.orBit(rlo, b.notBit(read(Field::TimerStarted))));
  if constexpr (K == Kind::OffDelay) {
    b.guard(b.orBit(rlo, b.notBit(read(Field::TimerHeld))));
    const Value same =
        b.make(Opcode::Equal, read(Field::TimerKind), b.constant(static_cast<std::uint32_t>(K)));
    b.guard(b.orBit(b.notBit(rlo), same));
  }
  endChain(l);
  return true;
}

// S7-TMR-21, S7-CNT-13: the next start instruction with RLO 1 counts as an edge again.
bool enable(Lowering& l) {
  const bool timer = isTimer(l.operand().kind);
  const auto cell = timer ? timerOf(l) : counterOf(l);
  if (!cell) return false;
  icode::Builder& b = l.to;
  const Field memory = timer ? Field::TimerEnableEdge : Field::CounterEnableEdge;
  const Value keep = b.notBit(rising(b, memory, *cell));
  const auto clear = [&](Field field) {
    b.setField(field, *cell, b.andBit(b.field(field, *cell), keep));
  };
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
  const auto counter = counterOf(l);
  if (!counter) return false;
  icode::Builder& b = l.to;
  const Value edge = rising(b, Up ? Field::CounterUpEdge : Field::CounterDownEdge, *counter);
  const Value count = b.field(Field::CounterCount, *counter);
  const Value room = Up ? b.make(Opcode::Below, count, b.constant(999))
                        : b.make(Opcode::NotEqual, count, b.constant(0));
  const Value by = b.make(Opcode::ToWord, b.andBit(edge, room));
  b.setField(Field::CounterCount, *counter, b.make(Up ? Opcode::Add : Opcode::Sub, count, by));
  endChain(l);
  return true;
}

Value timerValue(Lowering& l, std::uint32_t timer, bool bcd) {
  icode::Builder& b = l.to;
  const Value units = b.timerUnits(timer);
  if (!bcd) return units;
  const Value base = b.withNumber(Opcode::Shl, b.field(Field::TimerBase, {timer}), 12);
  return b.make(Opcode::Or, base, toBcd(l, units, 3));
}

// Whoever loads a timer whose number is not in the instruction is noted by the interpreter
// (cpu/outlook.h).
template <bool Bcd>
bool load(Lowering& l) {
  const bool timer = l.operand().kind == OperandKind::Timer;
  const auto cell = timer ? timerOf(l) : counterOf(l);
  if (!cell) return false;
  icode::Builder& b = l.to;
  Value value = icode::kNoValue;
  if (timer)
    value = timerValue(l, cell->number, Bcd);
  else
    value = b.field(Field::CounterCount, *cell);
  if (!timer && Bcd) value = toBcd(l, value, 3);
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

bool isTimer(OperandKind kind) { return isAnyOf(kind, kTimers); }
bool isCounter(OperandKind kind) { return isAnyOf(kind, kCounters); }

std::optional<Cell> timerOf(Lowering& l) {
  if (!isTimer(l.operand().kind)) return std::nullopt;
  return cellOf(l, OperandKind::Timer, l.model.timers);
}
std::optional<Cell> counterOf(Lowering& l) {
  if (!isCounter(l.operand().kind)) return std::nullopt;
  return cellOf(l, OperandKind::Counter, l.model.counters);
}

// S7-TMR: started and not yet over, the delays started and over; SS and SA also while held. Only
// the first of these changes between one turn of a loop and the next.
Value timerStatus(Lowering& l, const Cell& timer) {
  icode::Builder& b = l.to;
  const auto read = [&](Field field) { return b.field(field, timer); };
  const auto number = [&b](Kind kind) { return b.constant(static_cast<std::uint32_t>(kind)); };
  static_assert(Kind::StoredOnDelay > Kind::OnDelay && Kind::OffDelay > Kind::StoredOnDelay);
  const Value kind = read(Field::TimerKind);
  const Value isDelay =
      b.make(Opcode::Below, b.make(Opcode::Sub, kind, number(Kind::OnDelay)), b.constant(2));
  const Value isStored = b.notBit(b.make(Opcode::Below, kind, number(Kind::StoredOnDelay)));
  const Value over = b.xorBit(b.timerRuns(timer), isDelay);
  return b.orBit(b.andBit(over, read(Field::TimerStarted)),
                 b.andBit(isStored, read(Field::TimerHeld)));
}

Value counterStatus(Lowering& l, const Cell& counter) {
  return l.to.make(Opcode::NotEqual, l.to.field(Field::CounterCount, counter), l.to.constant(0));
}

bool loadTimerOrCounter(Lowering& l) { return load<false>(l); }

// S7-TMR-06, S7-CNT-04: as long as RLO is 1.
bool resetTimerOrCounter(Lowering& l) {
  const bool timer = isTimer(l.operand().kind);
  const auto cell = timer ? timerOf(l) : counterOf(l);
  if (!cell) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  const auto clear = [&](Field field) {
    b.setField(field, *cell, zeroIf(l, rlo, b.field(field, *cell)));
  };
  if (timer) {
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
  const auto counter = counterOf(l);
  if (!counter) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  const Value quiet = b.orBit(b.notBit(rlo), b.field(Field::CounterSetEdge, *counter));
  const Value bcd = b.make(Opcode::And, b.get(Item::Accu1), b.constant(0xFFF));
  b.guard(b.orBit(quiet, isBcd(l, bcd)));
  const Value edge = rising(b, Field::CounterSetEdge, *counter);
  const Value kept = zeroIf(l, edge, b.field(Field::CounterCount, *counter));
  const Value set = zeroIf(l, b.notBit(edge), fromBcd(l, bcd, 3));
  b.setField(Field::CounterCount, *counter, b.make(Opcode::Or, kept, set));
  endChain(l);
  return true;
}

}  // namespace merker::translate
