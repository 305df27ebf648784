// Jumps inside a block (S7-INSTR-112 … -126, -128).
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Value;
using mc7::Operation;

// Nothing: the jump leads nowhere, which is the interpreter's business.
std::optional<std::uint32_t> target(Lowering& l) {
  const std::int32_t to = l.listing.target(l.listing.places[l.place]);
  const bool inside = to >= 0 && static_cast<std::size_t>(to) < l.listing.places.size();
  return inside ? std::optional(static_cast<std::uint32_t>(to)) : std::nullopt;
}

// The jump over the list of parameters behind a call leads to the next instruction. In a loop the
// region goes on with the next turn, and leaves where the loop ends.
void branch(Lowering& l, Value bit, bool wanted, std::uint32_t to) {
  if (to == l.place + 1) return;
  if (l.follows) l.next = to;
  l.to.branch(bit, wanted != l.follows, l.follows ? l.place + 1 : to);
}

bool always(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  if (*to == l.place + 1) return true;
  if (l.follows) {
    l.next = *to;
    return true;
  }
  l.to.leave(*to);
  l.ended = true;
  return true;
}

template <bool Wanted, bool SaveToBr>
bool onRlo(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  icode::Builder& b = l.to;
  const Value rlo = b.get(Item::Rlo);
  if constexpr (SaveToBr) b.set(Item::Br, rlo);
  b.set(Item::Rlo, true);
  b.set(Item::Sta, true);
  b.set(Item::Or, false);
  b.set(Item::Er, false);
  branch(l, rlo, Wanted, *to);
  return true;
}

template <bool Wanted>
bool onBr(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  icode::Builder& b = l.to;
  b.set(Item::Sta, true);
  b.set(Item::Or, false);
  b.set(Item::Er, false);
  branch(l, b.get(Item::Br), Wanted, *to);
  return true;
}

bool onOverflow(Lowering& l) {
  const auto to = target(l);
  if (to) branch(l, l.to.get(Item::Ov), true, *to);
  return to.has_value();
}

bool onStoredOverflow(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  const Value stored = l.to.get(Item::Os);
  l.to.set(Item::Os, false);
  l.to.branch(stored, true, *to);
  return true;
}

enum class When : std::uint8_t { Zero, Minus, Plus, Unordered, NotZero, MinusOrZero, PlusOrZero };

template <When W>
bool onConditions(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  icode::Builder& b = l.to;
  const Value plus = b.get(Item::Cc1), minus = b.get(Item::Cc0);
  switch (W) {
    case When::Zero:
      branch(l, b.orBit(plus, minus), false, *to);
      break;
    case When::Minus:
      branch(l, b.andBit(minus, b.notBit(plus)), true, *to);
      break;
    case When::Plus:
      branch(l, b.andBit(plus, b.notBit(minus)), true, *to);
      break;
    case When::Unordered:
      branch(l, b.andBit(plus, minus), true, *to);
      break;
    case When::NotZero:
      branch(l, b.xorBit(plus, minus), true, *to);
      break;
    case When::MinusOrZero:
      branch(l, plus, false, *to);
      break;
    case When::PlusOrZero:
      branch(l, minus, false, *to);
      break;
  }
  return true;
}

// The list of SPL: as many SPA as it says, one behind the other. Nothing: it is not whole.
std::optional<std::uint32_t> behindList(const Lowering& l) {
  const auto& places = l.listing.places;
  const mc7::Place& here = places[l.place];
  const std::uint32_t entries = here.instruction.operand.value;
  for (std::uint32_t i = 1; i <= entries; ++i) {
    if (l.place + i >= places.size()) return std::nullopt;
    const mc7::Place& entry = places[l.place + i];
    if (!entry.known || entry.instruction.operation != Operation::SPA ||
        entry.offset != here.offset + 4 * i)
      return std::nullopt;
  }
  const std::uint32_t behind = l.place + 1 + entries;
  return behind < places.size() && places[behind].offset == here.offset + 4 * (entries + 1)
             ? std::optional(behind)
             : std::nullopt;
}

// S7-INSTR-127: by AKKU1-LL into the list, or behind it. A long list is left to the interpreter.
bool distribute(Lowering& l) {
  constexpr std::uint32_t kMost = 16;
  const auto behind = behindList(l);
  const std::uint32_t entries = l.operand().value;
  if (!behind || entries > kMost) return false;
  icode::Builder& b = l.to;
  const Value number = b.make(Opcode::Zext8, b.get(Item::Accu1));
  for (std::uint32_t i = 0; i < entries; ++i)
    b.branch(b.make(Opcode::Equal, number, b.constant(i)), true, l.place + 1 + i);
  b.leave(*behind);
  l.ended = true;
  return true;
}

bool loop(Lowering& l) {
  const auto to = target(l);
  if (!to) return false;
  icode::Builder& b = l.to;
  const Value before = b.get(Item::Accu1);
  const Value after = b.make(Opcode::Sub, before, b.constant(1));
  b.set(Item::Accu1, b.make(Opcode::LowFrom, before, after));
  branch(l, b.make(Opcode::NotEqual, b.make(Opcode::Zext16, after), b.constant(0)), true, *to);
  return true;
}

constexpr Row kJumpsRows[] = {{Operation::SPA, always},
                              {Operation::SPB, onRlo<true, false>},
                              {Operation::SPBN, onRlo<false, false>},
                              {Operation::SPBB, onRlo<true, true>},
                              {Operation::SPBNB, onRlo<false, true>},
                              {Operation::SPBI, onBr<true>},
                              {Operation::SPBIN, onBr<false>},
                              {Operation::SPO, onOverflow},
                              {Operation::SPS, onStoredOverflow},
                              {Operation::SPU, onConditions<When::Unordered>},
                              {Operation::SPZ, onConditions<When::Zero>},
                              {Operation::SPP, onConditions<When::Plus>},
                              {Operation::SPM, onConditions<When::Minus>},
                              {Operation::SPN, onConditions<When::NotZero>},
                              {Operation::SPMZ, onConditions<When::MinusOrZero>},
                              {Operation::SPPZ, onConditions<When::PlusOrZero>},
                              {Operation::SPL, distribute},
                              {Operation::LOOP, loop}};

}  // namespace

std::span<const Row> jumpRows() { return kJumpsRows; }

}  // namespace merker::translate
