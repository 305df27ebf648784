// Calls, block ends, A DB (9.3.6): ways into other blocks and back.
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Item;
using icode::Space;
using icode::Value;
using mc5::Operation;

constexpr std::uint32_t kDataBlocks = 256;

std::uint32_t behind(const Lowering& l) { return l.place + l.decoded.words; }

// In the block that is called, and in the one to which it returns (OP-24).
void leaveChain(Lowering& l) {
  l.to.set(Item::Or, false);
  l.to.set(Item::Er, false);
}
void enterChain(Lowering& l) {
  l.to.set(Item::Os, false);
  leaveChain(l);
}

// A condition that is not met leaves VKE = 1 (S5-BLK-16, OP-50) and costs the shorter time.
void notTaken(Lowering& l) {
  l.to.cost(static_cast<std::uint64_t>(l.times().shortest.ns));
  l.to.set(Item::Rlo, true);
  leaveChain(l);
}

// What this processor does not do itself: only as long as the condition is not met.
bool onlyNotTaken(Lowering& l) {
  if (!l.mayLeave()) return false;
  l.leaves = true;  // the block that is called comes back behind it
  l.to.guard(l.to.notBit(l.to.get(Item::Rlo)));
  notTaken(l);
  return true;
}

bool call(Lowering& l) {
  const auto site = l.site();
  if (!site) return false;
  const std::uint32_t front = l.to.front();
  enterChain(l);
  l.to.callFrom(*site, behind(l), front);
  l.ended = true;
  return true;
}

bool callIf(Lowering& l) {
  const auto site = l.site();
  if (!site) return onlyNotTaken(l);
  const Value vke = l.to.get(Item::Rlo);
  const std::uint32_t front = l.to.front();
  const auto before = l.to.registers();
  enterChain(l);
  l.to.callFrom(*site, behind(l), front, vke);
  l.to.restore(before);
  notTaken(l);
  l.leaves = true;
  return true;
}

bool end(Lowering& l) {
  if (l.sites == nullptr || !l.mayLeave()) return false;
  const std::uint32_t front = l.to.front();
  enterChain(l);
  l.to.returnFrom(front);
  l.ended = true;
  return true;
}

bool endIf(Lowering& l) {
  if (l.sites == nullptr || !l.mayLeave()) return onlyNotTaken(l);
  const Value vke = l.to.get(Item::Rlo);
  const std::uint32_t front = l.to.front();
  const auto before = l.to.registers();
  enterChain(l);
  l.to.returnFrom(front, vke);
  l.to.restore(before);
  notTaken(l);
  return true;
}

// What the next instructions need of the block is looked at where their region begins.
bool open(Lowering& l) {
  const mc5::Operand& operand = l.operand();
  const bool names = operand.kind == mc5::OperandKind::Block && operand.value < kDataBlocks;
  if (l.sites == nullptr || !l.mayLeave() || !names) return false;
  l.to.open(Space::Data, l.to.constant(operand.value), {});
  l.to.leave(behind(l));
  l.ended = true;
  return true;
}

constexpr Row kLinksRows[] = {{Operation::CALL, call},      {Operation::CALL_IF, callIf},
                              {Operation::END, end},        {Operation::END_IF, endIf},
                              {Operation::END_ALWAYS, end}, {Operation::OPEN, open}};

}  // namespace

std::span<const Row> linkRows() { return kLinksRows; }

}  // namespace merker::translate5
