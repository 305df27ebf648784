// UC CC BE BEA BEB (S7-INSTR-106 … -110), AUF and TDB (S7-INSTR-47, -48). Blocks that are missing,
// exhausted stacks and system blocks are left to the interpreter.
#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Item;
using icode::Opcode;
using icode::Space;
using icode::Value;
using mc7::OperandKind;
using mc7::Operation;

std::optional<Value> blockNumber(Lowering& l) {
  const mc7::Operand& o = l.operand();
  if (o.kind == OperandKind::Block) return l.to.constant(o.value);
  return numberOperand(l);
}

// OS 0, OR 0, STA 1, /ER 0.
void finish(Lowering& l) {
  l.to.set(Item::Os, false);
  l.to.set(Item::Sta, true);
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}

bool isLoadable(BlockKind kind) { return kind == BlockKind::FC || kind == BlockKind::FB; }

icode::CallSite siteOf(const Lowering& l) {
  const mc7::Place& place = l.listing.places[l.place];
  return {.functionBlock = l.operand().blockKind == BlockKind::FB,
          .offset = place.offset,
          .resume = l.place + 1,
          .firstParameter = place.firstParameter,
          .parameters = place.parameters};
}

template <bool Conditional>
bool call(Lowering& l) {
  if (!isLoadable(l.operand().blockKind)) return false;
  const auto number = blockNumber(l);
  if (!number) return false;
  icode::Builder& b = l.to;
  const std::uint32_t front = b.front();
  if constexpr (Conditional) {  // afterwards VKE is 1, called or not
    const Value rlo = b.get(Item::Rlo);
    finish(l);
    b.set(Item::Rlo, true);
    b.branch(rlo, false, l.place + 1);
  } else {
    finish(l);
  }
  b.call(*number, siteOf(l), front);
  l.ended = true;
  return true;
}

bool end(Lowering& l) {
  const std::uint32_t front = l.to.front();
  finish(l);
  l.to.giveBack(front);
  l.ended = true;
  return true;
}

bool endIf(Lowering& l) {
  icode::Builder& b = l.to;
  const std::uint32_t front = b.front();
  const Value rlo = b.get(Item::Rlo);
  b.set(Item::Rlo, true);
  b.set(Item::Sta, true);
  b.set(Item::Or, false);
  b.set(Item::Er, false);
  b.branch(rlo, false, l.place + 1);
  b.set(Item::Os, false);
  b.giveBack(front);
  l.ended = true;
  return true;
}

bool openBlock(Lowering& l) {
  const auto number = blockNumber(l);
  if (!number) return false;
  const Space space = l.operand().reg == 1 ? Space::Instance : Space::Data;
  const Wanted wanted = lookout(l, space);
  l.to.open(space, *number, {.bytes = wanted.end, .write = wanted.write});
  if (wanted.end != 0)
    l.reached.push_back({icode::kNoValue, l.to.limit(space, wanted.write), wanted.end});
  return true;
}

bool exchange(Lowering& l) {
  l.to.swapBlocks();
  return true;
}

constexpr Row kCallsRows[] = {{Operation::UC, call<false>},  {Operation::CC, call<true>},
                              {Operation::BE, end},          {Operation::BEA, end},
                              {Operation::BEB, endIf},       {Operation::OPEN, openBlock},
                              {Operation::SWAP_DB, exchange}};

}  // namespace

std::span<const Row> callRows() { return kCallsRows; }

}  // namespace merker::translate
