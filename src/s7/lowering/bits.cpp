// Bit logic, brackets, outputs, edges and status bits (S7-INSTR-02 … -25).
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::OperandKind;
using mc7::Operation;
using mc7::StatusQuery;

// The equations of the ledger; with /ER known they shrink to one operation.
void andWith(Lowering& l, Value term, Value state) {
  icode::Builder& b = l.to;
  const Value er = b.get(Item::Er);
  const Value kept = b.andBit(b.get(Item::Or), er);
  const Value before = b.orBit(b.get(Item::Rlo), b.notBit(er));
  b.set(Item::Rlo, b.orBit(b.andBit(before, term), kept));
  b.set(Item::Or, kept);
  b.set(Item::Sta, state);
  b.set(Item::Er, true);
}

template <bool Exclusive>
void orWith(Lowering& l, Value term, Value state) {
  icode::Builder& b = l.to;
  const Value before = b.andBit(b.get(Item::Rlo), b.get(Item::Er));
  b.set(Item::Rlo, Exclusive ? b.xorBit(before, term) : b.orBit(before, term));
  b.set(Item::Or, false);
  b.set(Item::Sta, state);
  b.set(Item::Er, true);
}

void endChain(Lowering& l) {
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}

enum class Logic : std::uint8_t { And, Or, Xor };

template <Logic L, bool Negated>
bool query(Lowering& l) {
  const auto state = readBit(l);
  if (!state) return false;
  const Value term = Negated ? l.to.notBit(*state) : *state;
  if constexpr (L == Logic::And) andWith(l, term, *state);
  if constexpr (L == Logic::Or) orWith<false>(l, term, *state);
  if constexpr (L == Logic::Xor) orWith<true>(l, term, *state);
  return true;
}

bool open(Lowering& l) {
  icode::Builder& b = l.to;
  l.needs.noBrackets = true;
  l.brackets.push_back({b.get(Item::Rlo), b.get(Item::Or), b.get(Item::Er)});
  b.set(Item::Sta, true);
  endChain(l);
  return true;
}

// A stored /ER of 0 makes what the bracket gives a first check.
bool close(Lowering& l, Operation function) {
  icode::Builder& b = l.to;
  const auto [rlo, orBit, er] = l.brackets.back();
  l.brackets.pop_back();
  const Value inner = b.get(Item::Rlo);
  const bool isAnd = function == Operation::AND_OPEN || function == Operation::AND_NOT_OPEN;
  const bool isXor = function == Operation::XOR_OPEN || function == Operation::XOR_NOT_OPEN;
  const bool negated = function == Operation::AND_NOT_OPEN || function == Operation::OR_NOT_OPEN ||
                       function == Operation::XOR_NOT_OPEN;
  const Value term = negated ? b.notBit(inner) : inner;
  const Value kept = isAnd ? b.andBit(orBit, er) : b.constant(0);
  const Value before = isAnd ? b.orBit(rlo, b.notBit(er)) : b.andBit(rlo, er);
  const Value result = isAnd   ? b.andBit(before, term)
                       : isXor ? b.xorBit(before, term)
                               : b.orBit(before, term);
  b.set(Item::Or, kept);
  b.set(Item::Rlo, b.orBit(result, kept));
  b.set(Item::Sta, true);
  b.set(Item::Er, true);
  return true;
}

// The opening bracket that this one closes.
bool closing(Lowering& l) {
  if (l.brackets.empty()) return false;
  unsigned depth = 0;
  for (std::uint32_t i = l.place; i-- > 0;) {
    const Operation operation = l.listing.places[i].instruction.operation;
    if (operation == Operation::CLOSE)
      ++depth;
    else if (operation >= Operation::AND_OPEN && operation <= Operation::XOR_NOT_OPEN &&
             depth-- == 0)
      return close(l, operation);
  }
  return false;
}

bool andBeforeOr(Lowering& l) {
  icode::Builder& b = l.to;
  const Value er = b.get(Item::Er), rlo = b.get(Item::Rlo);
  b.set(Item::Or, b.andBit(b.orBit(rlo, b.get(Item::Or)), er));
  b.set(Item::Er, b.andBit(rlo, er));
  b.set(Item::Sta, true);
  return true;
}

bool assign(Lowering& l) {
  const auto place = bitPlace(l, true);
  if (!place) return false;
  l.needs.relayOn = true;
  const Value rlo = l.to.get(Item::Rlo);
  storeByte(l, *place, withBit(l, *place, loadByte(l, *place), rlo));
  l.to.set(Item::Sta, rlo);
  endChain(l);
  return true;
}

template <bool Set>
bool setOrReset(Lowering& l) {
  if (isCounter(l.operand().kind) || isTimer(l.operand().kind))
    return Set ? setCounter(l) : resetTimerOrCounter(l);
  const auto place = bitPlace(l, true);
  if (!place) return false;
  icode::Builder& b = l.to;
  l.needs.relayOn = true;
  const Value rlo = b.get(Item::Rlo), byte = loadByte(l, *place);
  if (place->bit == icode::kNoValue) {
    constexpr Opcode kWhere = Set ? Opcode::SetWhere : Opcode::ClearWhere;
    storeByte(l, *place, b.make(kWhere, byte, rlo, place->direct));
  } else {
    const Value before = bitIn(l, *place, byte);
    const Value after = Set ? b.orBit(before, rlo) : b.andBit(before, b.notBit(rlo));
    storeByte(l, *place, withBit(l, *place, byte, after));
  }
  b.set(Item::Sta, rlo);
  endChain(l);
  return true;
}

template <bool Rising>
bool edge(Lowering& l) {
  const auto place = bitPlace(l, true);
  if (!place) return false;
  icode::Builder& b = l.to;
  const Value now = b.get(Item::Rlo), byte = loadByte(l, *place);
  const Value before = bitIn(l, *place, byte);
  storeByte(l, *place, withBit(l, *place, byte, now));
  b.set(Item::Rlo, Rising ? b.andBit(now, b.notBit(before)) : b.andBit(b.notBit(now), before));
  b.set(Item::Sta, now);
  b.set(Item::Or, false);
  b.set(Item::Er, true);
  return true;
}

template <bool Value>
bool fixed(Lowering& l) {
  l.to.set(Item::Rlo, Value);
  l.to.set(Item::Sta, Value);
  endChain(l);
  return true;
}

bool invert(Lowering& l) {
  l.to.set(Item::Rlo, l.to.notBit(l.to.get(Item::Rlo)));
  l.to.set(Item::Sta, true);
  return true;
}

bool save(Lowering& l) {
  l.to.set(Item::Br, l.to.get(Item::Rlo));
  return true;
}

Value stateOf(icode::Builder& b, StatusQuery query) {
  const Value plus = b.get(Item::Cc1), minus = b.get(Item::Cc0);
  switch (query) {
    case StatusQuery::OS:
      return b.get(Item::Os);
    case StatusQuery::OV:
      return b.get(Item::Ov);
    case StatusQuery::Greater:
      return b.andBit(plus, b.notBit(minus));
    case StatusQuery::Less:
      return b.andBit(minus, b.notBit(plus));
    case StatusQuery::Unordered:
      return b.andBit(plus, minus);
    case StatusQuery::NotEqual:
      return b.xorBit(plus, minus);
    case StatusQuery::Equal:
      return b.notBit(b.orBit(plus, minus));
    case StatusQuery::GreaterEqual:
      return b.notBit(minus);
    case StatusQuery::LessEqual:
      return b.notBit(plus);
    case StatusQuery::BIE:
      return b.get(Item::Br);
  }
  return b.constant(0);
}

constexpr Row kBitsRows[] = {{Operation::AND, query<Logic::And, false>},
                             {Operation::AND_NOT, query<Logic::And, true>},
                             {Operation::OR, query<Logic::Or, false>},
                             {Operation::OR_NOT, query<Logic::Or, true>},
                             {Operation::XOR, query<Logic::Xor, false>},
                             {Operation::XOR_NOT, query<Logic::Xor, true>},
                             {Operation::AND_OPEN, open},
                             {Operation::AND_NOT_OPEN, open},
                             {Operation::OR_OPEN, open},
                             {Operation::OR_NOT_OPEN, open},
                             {Operation::XOR_OPEN, open},
                             {Operation::XOR_NOT_OPEN, open},
                             {Operation::CLOSE, closing},
                             {Operation::AND_BEFORE_OR, andBeforeOr},
                             {Operation::ASSIGN, assign},
                             {Operation::SET_BIT, setOrReset<true>},
                             {Operation::RESET_BIT, setOrReset<false>},
                             {Operation::EDGE_POSITIVE, edge<true>},
                             {Operation::EDGE_NEGATIVE, edge<false>},
                             {Operation::CLR, fixed<false>},
                             {Operation::SET, fixed<true>},
                             {Operation::NOT, invert},
                             {Operation::SAVE, save}};

bool isQuery(Operation o) { return o <= Operation::XOR_NOT; }

// Changes status bits only.
bool cannotFail(Operation o) {
  return o == Operation::AND_BEFORE_OR || o == Operation::NOT || o == Operation::CLOSE;
}

bool prepareQuery(Lowering& outer, std::uint32_t place) {
  const mc7::Place& inner = outer.listing.places[place];
  if (!inner.known || !isQuery(inner.instruction.operation)) return false;
  const OperandKind kind = inner.instruction.operand.kind;
  const std::uint32_t number = inner.instruction.operand.value;
  if (kind == OperandKind::StatusBit) return true;
  if (kind == OperandKind::Timer) return number < outer.model.timers;
  if (kind == OperandKind::Counter) return number < outer.model.counters;
  if (kind != OperandKind::Memory && kind != OperandKind::MemoryIndirect &&
      kind != OperandKind::RegisterIndirect && kind != OperandKind::RegisterCrossing &&
      kind != OperandKind::Parameter)
    return false;
  Lowering l{outer.to,       outer.needs,   outer.model, outer.listing, place,
             outer.brackets, outer.reached, outer.ahead, outer.inside};
  const auto found = bitPlace(l, false);
  if (found) outer.ahead.emplace(place, *found);
  return found.has_value();
}

}  // namespace

std::span<const Row> bitRows() { return kBitsRows; }

std::optional<Value> readBit(Lowering& l) {
  const mc7::Operand& o = l.operand();
  icode::Builder& b = l.to;
  if (o.kind == OperandKind::StatusBit) return stateOf(b, static_cast<StatusQuery>(o.value));
  if (isTimer(o.kind)) {
    const auto timer = timerOf(l);
    return timer ? std::optional(timerStatus(l, *timer)) : std::nullopt;
  }
  if (isCounter(o.kind)) {
    const auto counter = counterOf(l);
    return counter ? std::optional(counterStatus(l, *counter)) : std::nullopt;
  }
  const auto place = bitPlace(l, false);
  if (!place) return std::nullopt;
  return bitIn(l, *place, loadByte(l, *place));
}

bool prepareBracket(Lowering& l, std::span<const std::uint8_t> isEntry) {
  constexpr std::uint32_t kLongest = 64, kDeepest = 6;
  std::uint32_t depth = 1;
  const auto& places = l.listing.places;
  for (std::uint32_t i = l.place + 1; i < places.size() && i < l.place + kLongest; ++i) {
    if (isEntry[i] != 0) return false;
    const Operation o = places[i].instruction.operation;
    if (isOpening(o)) {
      if (++depth > kDeepest) return false;
      continue;
    }
    if (!cannotFail(o) && !prepareQuery(l, i)) return false;
    if (o == Operation::CLOSE && --depth == 0) return true;
  }
  return false;
}

}  // namespace merker::translate
