// Jumps (9.4.11). The instruction at a label begins a new chain (S5-JUMP-07).
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Value;
using mc5::Operation;

// Word of the block; out of the block leads only the processor.
std::optional<std::uint32_t> target(const Lowering& l) {
  const auto distance = static_cast<std::int32_t>(l.operand().value);
  const std::int64_t to = std::int64_t{l.place} + distance;
  if (!l.mayLeave() || to < 0 || to >= l.length) return std::nullopt;
  return static_cast<std::uint32_t>(to);
}

void endChain(Lowering& l) {
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}

bool always(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  endChain(l);
  l.to.leave(*to);
  l.ended = true;
  return true;
}

// Not taken it costs the shorter time (S5-OPC-04).
bool jumpWhen(Lowering& l, Value condition, std::uint32_t to) {
  endChain(l);
  l.to.branch(condition, true, to);
  l.to.cost(static_cast<std::uint64_t>(l.times().shortest.ns));
  return true;
}

// VKE is 1 afterwards also when it was not taken (S5-JUMP-01).
bool ifVke(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  const Value vke = l.to.get(Item::Rlo);
  l.to.set(Item::Rlo, true);
  return jumpWhen(l, vke, *to);
}

template <Value Condition(Lowering&)>
bool conditional(Lowering& l) {
  const auto to = target(l);
  return to && jumpWhen(l, Condition(l), *to);
}

Value anz(Lowering& l, bool high) { return l.to.get(high ? Item::Cc1 : Item::Cc0); }
Value zero(Lowering& l) { return l.to.notBit(l.to.orBit(anz(l, true), anz(l, false))); }
Value notZero(Lowering& l) { return l.to.xorBit(anz(l, true), anz(l, false)); }
Value plus(Lowering& l) { return l.to.andBit(anz(l, true), l.to.notBit(anz(l, false))); }
Value minus(Lowering& l) { return l.to.andBit(anz(l, false), l.to.notBit(anz(l, true))); }
Value overflow(Lowering& l) { return l.to.get(Item::Ov); }
Value stored(Lowering& l) {
  const Value bit = l.to.get(Item::Os);
  l.to.set(Item::Os, false);  // OP-24
  return bit;
}

constexpr Row kJumpsRows[] = {{Operation::JUMP, always},
                              {Operation::JUMP_IF, ifVke},
                              {Operation::JUMP_ZERO, conditional<zero>},
                              {Operation::JUMP_NOT_ZERO, conditional<notZero>},
                              {Operation::JUMP_PLUS, conditional<plus>},
                              {Operation::JUMP_MINUS, conditional<minus>},
                              {Operation::JUMP_OVERFLOW, conditional<overflow>},
                              {Operation::JUMP_STORED, conditional<stored>}};

}  // namespace

std::span<const Row> jumpRows() { return kJumpsRows; }

}  // namespace merker::translate5
