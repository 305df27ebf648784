// Binary logic, memory operations, bit test (9.3.1, 9.3.2, 9.4.5).
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc5::Operation;

Value inverted(Lowering& l, bool wanted, Value bit) { return wanted ? l.to.notBit(bit) : bit; }

// VKE, OR of a chain that is in progress.
Value chained(Lowering& l, Item item) { return l.to.andBit(l.to.get(item), l.to.get(Item::Er)); }

void scanned(Lowering& l, Value vke, Value orBit, Value signal) {
  l.to.set(Item::Rlo, vke);
  l.to.set(Item::Or, orBit);
  l.to.set(Item::Sta, signal);
  l.to.set(Item::Er, true);
}

// S5-BIT-02, S5-STAT-04: at the first scan VKE counts as 1.
template <bool Inverted>
bool andWith(Lowering& l) {
  const auto signal = readBit(l);
  if (!signal) return false;
  icode::Builder& b = l.to;
  const Value orBit = chained(l, Item::Or);
  const Value before = b.orBit(b.get(Item::Rlo), b.notBit(b.get(Item::Er)));
  scanned(l, b.orBit(b.andBit(before, inverted(l, Inverted, *signal)), orBit), orBit, *signal);
  return true;
}

template <bool Inverted>
bool orWith(Lowering& l) {
  const auto signal = readBit(l);
  if (!signal) return false;
  const Value vke = l.to.orBit(chained(l, Item::Rlo), inverted(l, Inverted, *signal));
  scanned(l, vke, l.to.constant(0), *signal);
  return true;
}

// S5-BIT-07
bool andBeforeOr(Lowering& l) {
  icode::Builder& b = l.to;
  const Value chain = b.get(Item::Er), vke = b.get(Item::Rlo);
  b.set(Item::Or, b.andBit(b.orBit(vke, b.get(Item::Or)), chain));
  b.set(Item::Er, b.andBit(vke, chain));
  b.set(Item::Sta, true);
  return true;
}

template <bool IsOr>
bool open(Lowering& l) {
  icode::Builder& b = l.to;
  const Value chain = b.get(Item::Er), vke = b.get(Item::Rlo);
  const Value before = IsOr ? b.andBit(chain, vke) : b.orBit(b.notBit(chain), vke);
  l.brackets.push_back({before, chained(l, Item::Or), IsOr});
  b.set(Item::Or, false);
  b.set(Item::Er, false);
  b.set(Item::Sta, true);
  return true;
}

// Of a bracket that was opened outside of the region nobody knows here.
bool close(Lowering& l) {
  if (l.brackets.empty()) return false;
  icode::Builder& b = l.to;
  const Bracket bracket = l.brackets.back();
  l.brackets.pop_back();
  const Value vke = b.get(Item::Rlo);
  const Value both = b.orBit(b.andBit(bracket.vke, vke), bracket.orBit);
  scanned(l, bracket.isOr ? b.orBit(bracket.vke, vke) : both, bracket.orBit, b.constant(1));
  return true;
}

void endChain(Lowering& l, Value status) {
  l.to.set(Item::Sta, status);
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}

void change(Lowering& l, const BytePlace& at, Opcode how, Value bit) {
  const Value byte = l.to.load(at.space, at.byte, 1);
  l.to.store(at.space, at.byte, 1, l.to.make(how, byte, bit, at.bit));
}

bool assign(Lowering& l) {
  const auto place = bitPlace(l, true);
  if (!place) return false;
  const Value vke = l.to.get(Item::Rlo);
  change(l, *place, Opcode::Insert, vke);
  endChain(l, vke);
  return true;
}

bool sameTime(const Lowering& l) { return l.times().shortest == l.times().longest; }

bool setBit(Lowering& l) {
  if (l.operand().kind == mc5::OperandKind::Counter) return setCell(l);
  const auto place = sameTime(l) ? bitPlace(l, true) : std::nullopt;
  if (!place) return false;
  const Value vke = l.to.get(Item::Rlo), before = *readBit(l);
  change(l, *place, Opcode::SetWhere, vke);
  endChain(l, l.to.orBit(before, vke));
  return true;
}

bool resetBit(Lowering& l) {
  if (isCell(l.operand())) return resetCell(l);
  const auto place = sameTime(l) ? bitPlace(l, true) : std::nullopt;
  if (!place) return false;
  const Value vke = l.to.get(Item::Rlo), before = *readBit(l);
  change(l, *place, Opcode::ClearWhere, vke);
  endChain(l, l.to.andBit(before, l.to.notBit(vke)));
  return true;
}

// P and PN begin a chain whatever stood before (S5-BITTEST-02).
template <bool Inverted>
bool test(Lowering& l) {
  const auto signal = readBit(l);
  if (!signal) return false;
  scanned(l, inverted(l, Inverted, *signal), l.to.constant(0), *signal);
  return true;
}

template <bool Value>
bool force(Lowering& l) {
  const auto place = bitPlace(l, true);
  if (!place) return false;
  change(l, *place, Opcode::Insert, l.to.constant(Value));
  return true;
}

constexpr Row kBitsRows[] = {{Operation::AND, andWith<false>},
                             {Operation::AND_NOT, andWith<true>},
                             {Operation::OR, orWith<false>},
                             {Operation::OR_NOT, orWith<true>},
                             {Operation::AND_BEFORE_OR, andBeforeOr},
                             {Operation::AND_OPEN, open<false>},
                             {Operation::OR_OPEN, open<true>},
                             {Operation::CLOSE, close},
                             {Operation::ASSIGN, assign},
                             {Operation::SET_BIT, setBit},
                             {Operation::RESET_BIT, resetBit},
                             {Operation::TEST_BIT, test<false>},
                             {Operation::TEST_NOT, test<true>},
                             {Operation::SET_ALWAYS, force<true>},
                             {Operation::RESET_ALWAYS, force<false>}};

}  // namespace

std::span<const Row> bitRows() { return kBitsRows; }

}  // namespace merker::translate5
